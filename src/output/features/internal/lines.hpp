#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "features/path/recording.hpp"

namespace kerf::output {

/// Lines of one file, from the first to the last one.
struct LineRange {
  base::FileId file = base::kNoFile;
  base::ProgramNumber program{};
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// The lines that rows come from, a range a file and program, in the order in which they ran. Rows
/// may come from a line several times.
[[nodiscard]] std::vector<LineRange> lines_of(const features::Recording& recording,
                                              std::span<const features::Span> spans);
/// The range of the file that the first row comes from.
[[nodiscard]] LineRange first_lines_of(const features::Recording& recording,
                                       std::span<const features::Span> spans);
[[nodiscard]] inline LineRange first_lines_of(const features::Recording& recording,
                                              const features::Span& span) {
  return first_lines_of(recording, std::span(&span, 1));
}

/// The rows of `kerf run --rows`.
[[nodiscard]] features::Span rows_of(const features::Recording& recording,
                                     std::span<const features::Span> spans);

}  // namespace kerf::output
