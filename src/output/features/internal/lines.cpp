#include "output/features/internal/lines.hpp"

#include <algorithm>

namespace kerf::output {
namespace {

void take(std::vector<LineRange>& ranges, const base::BlockId& block) {
  const auto is_its = [&](const LineRange& range) {
    return range.file == block.file && range.program == block.program;
  };
  const auto known = std::find_if(ranges.begin(), ranges.end(), is_its);
  if (known == ranges.end()) {
    ranges.push_back({block.file, block.program, block.line, block.line});
  } else {
    known->first = std::min(known->first, block.line);
    known->last = std::max(known->last, block.line);
  }
}

}  // namespace

std::vector<LineRange> lines_of(const features::Recording& recording,
                                std::span<const features::Span> spans) {
  std::vector<LineRange> ranges;
  for (const features::Span& span : spans) {
    for (std::uint32_t row = span.first; row <= span.last; ++row)
      take(ranges, recording.block_of(recording.moves[row]));
  }
  return ranges;
}

LineRange first_lines_of(const features::Recording& recording,
                         std::span<const features::Span> spans) {
  const auto ranges = lines_of(recording, spans);
  return ranges.empty() ? LineRange{} : ranges.front();
}

features::Span rows_of(const features::Recording& recording,
                       std::span<const features::Span> spans) {
  if (spans.empty()) return {};
  return {recording.moves[spans.front().first].row, recording.moves[spans.back().last].row};
}

}  // namespace kerf::output
