#pragma once

#include <cstdint>

#include "base/place.hpp"

namespace kerf::base {

/// Number of a program: 1 to 99999999; 0 for text without an O number.
enum class ProgramNumber : std::uint32_t {};

/// The calls that led to a block, as the CallPaths of its run know them.
enum class CallPath : std::uint32_t {
  main = 0,             ///< none
  unknown = 0xffffffff  ///< more than are kept
};

/// Which block of which program something comes from, however often and along whatever calls it is
/// executed: two blocks on one line, and two files with one O number, are two. In a language
/// without blocks, a statement. Value type; what its text was says its file.
struct BlockId {
  ProgramNumber program{};
  FileId file = kNoFile;
  std::uint32_t line = 0;      ///< in its file, from 1; 0: no block
  std::uint32_t column = 0;    ///< from 1, in bytes: where it begins; 0: not known
  std::uint64_t from = 0;      ///< offset of its first byte in its file
  std::uint32_t length = 0;    ///< in bytes, without the end of the block; 0: not known
  std::uint32_t sequence = 0;  ///< its N word; 0: none
  CallPath calls = CallPath::main;

  /// Behind its last byte.
  [[nodiscard]] std::uint64_t to() const { return from + length; }
  friend bool operator==(const BlockId&, const BlockId&) = default;
};

/// Where a block begins.
[[nodiscard]] inline Place place_of(const BlockId& block) {
  const std::uint32_t column = block.column > 0 ? block.column : 1;
  return {.file = block.file,
          .line = block.line,
          .column = column,
          .line_start = block.from - (column - 1)};
}

}  // namespace kerf::base
