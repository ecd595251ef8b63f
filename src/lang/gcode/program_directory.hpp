#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"

namespace kerf::gcode {

/// A program in a file: from behind its O word to the next program, the closing '%' or the file's
/// end.
struct ProgramEntry {
  std::uint32_t number = 0;      ///< 0: none (no O word, or a name)
  std::string name;              ///< of O<NAME> or <NAME>
  std::uint64_t begin = 0;       ///< byte offset behind the O word
  std::uint64_t end = 0;         ///< byte offset behind the last byte
  std::uint32_t line = 1;        ///< line number at `begin`
  std::uint64_t line_start = 0;  ///< byte offset of that line
};

/// "O0001", or the name of a program that has one; "O0000" without either.
[[nodiscard]] std::string name_of(const ProgramEntry& entry);

/// Text that is no part of any program, because of the '%' in `line` (LEX-1).
struct UnreadText {
  enum class Where : std::uint8_t { before_percent, behind_percent, behind_tape };
  Where where{};
  std::uint32_t line = 0;
};

/// The programs of a file in the order of the text, and what is wrong with their numbers
/// (docs/dialect.md §1.1).
struct ProgramDirectory {
  std::vector<ProgramEntry> programs;
  std::vector<base::Diagnostic> findings;  ///< PS0073, PS0074
  std::vector<UnreadText> unread;          ///< blanks, comments and further '%' do not count
};

/// Reads the file once from beginning to end. A file without O words is one program, if it holds
/// anything at all.
[[nodiscard]] ProgramDirectory read_directory(const base::SourceFile& file, base::FileId id);

}  // namespace kerf::gcode
