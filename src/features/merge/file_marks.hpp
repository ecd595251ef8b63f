#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/source_file.hpp"
#include "features/path/block_facts.hpp"

namespace kerf::features {

/// What stands where in a file.
struct FileMarks {
  /// Of loops: from WHILE to its END, from a block to the GOTO behind it that leads back to it.
  std::vector<LineSpan> loops;
  struct Label {
    std::uint64_t number = 0;  ///< N word
    std::uint32_t line = 0;
  };
  std::vector<Label> labels;  ///< in the order of the lines
};

/// Of what is longer than 64 MiB no marks are known.
[[nodiscard]] FileMarks marks_in(const base::SourceFile& file);

/// The line of an N word, the next one behind a line, else the first one; 0: there is none.
[[nodiscard]] std::uint32_t line_of(const FileMarks& marks, std::uint64_t number,
                                    std::uint32_t behind);

/// The shortest loop around lines.
[[nodiscard]] std::optional<LineSpan> innermost(const FileMarks& marks, LineSpan lines);

}  // namespace kerf::features
