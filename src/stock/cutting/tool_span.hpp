#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace kerf::stock {

/// From this motion on, until the next span, this tool made the moves that may cut.
struct ToolSpan {
  std::uint32_t motion = 0;
  std::uint32_t tool = 0;
};

/// The tool of a motion; spans rise. None: before the first, or motion 0, which is nobody's.
[[nodiscard]] inline std::optional<std::uint32_t> tool_at(const std::vector<ToolSpan>& spans,
                                                          std::uint32_t motion) {
  const auto after =
      std::upper_bound(spans.begin(), spans.end(), motion,
                       [](std::uint32_t m, const ToolSpan& span) { return m < span.motion; });
  if (motion == 0 || after == spans.begin()) return {};
  return (after - 1)->tool;
}

}  // namespace kerf::stock
