#pragma once

#include <span>

#include "stock/compare/comparison.hpp"

namespace kerf::stock::compare {

/// Where material begins or ends on a line: at a point of the part, or of the design.
struct Border {
  double at = 0;
  std::uint32_t point = Stretch::kNone;  ///< of the part; none: it is the design's

  [[nodiscard]] bool is_part() const { return point != Stretch::kNone; }
};

/// Material that only one of the two has.
struct Difference {
  Side side = Side::gouge;
  Border low;
  Border high;

  [[nodiscard]] double length_mm() const { return high.at - low.at; }
};

/// Calls act(difference) for each on a line, upwards. What both have are stretches in order and
/// apart, those of the part with their points. Where both end at one place it is the part's point.
template <class Act>
void each_difference(std::span<const Stretch> part, std::span<const Stretch> design,
                     const Act& act) {
  // Borders are numbered: an even one begins a stretch, an odd one ends it.
  const auto border = [](std::span<const Stretch> list, std::size_t number) {
    const Stretch& one = list[number / 2];
    return number % 2 == 0 ? Border{one.low, one.low_point} : Border{one.high, one.high_point};
  };
  std::size_t p = 0;
  std::size_t d = 0;
  Border from;
  while (p < 2 * part.size() || d < 2 * design.size()) {
    const bool has_part = p < 2 * part.size();
    const bool has_design = d < 2 * design.size();
    const bool is_part = has_part && (!has_design || border(part, p).at <= border(design, d).at);
    const Border to = is_part ? border(part, p) : border(design, d);
    if (p % 2 != d % 2 && to.at > from.at)
      act(Difference{p % 2 != 0 ? Side::excess : Side::gouge, from, to});
    const bool keeps = to.at == from.at && from.is_part() && !is_part;
    if (!keeps) from = to;
    ++(is_part ? p : d);
  }
}

}  // namespace kerf::stock::compare
