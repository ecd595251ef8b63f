#pragma once

#include <cstdint>

namespace kerf::base {

/// Index of a source file in the SourceSet of its machine.
enum class FileId : std::uint32_t {};
inline constexpr FileId kNoFile{0xffffffffU};

/// A stretch of text in a source file. Value type.
struct Place {
  FileId file = kNoFile;
  std::uint32_t line = 0;        ///< from 1; 0: no place
  std::uint32_t column = 0;      ///< from 1, in bytes
  std::uint32_t length = 0;      ///< bytes that the caret underlines; 0 counts as 1
  std::uint64_t line_start = 0;  ///< byte offset of the line in its file
};

}  // namespace kerf::base
