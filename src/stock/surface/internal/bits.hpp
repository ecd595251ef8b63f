#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "stock/surface/samples.hpp"

namespace kerf::stock::surface {

/// Bits [first, after) of a word; none where first >= after.
[[nodiscard]] constexpr std::uint64_t bit_run(int first, int after) {
  if (first >= after) return 0;
  const std::uint64_t below = after >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << after) - 1;
  return below & ~((std::uint64_t{1} << first) - 1);
}

/// Some of the points along an axis, of which those that exist may be in the material.
class PointRange {
 public:
  PointRange(const std::vector<double>& points, int first, int count) {
    const int size = static_cast<int>(points.size());
    const int from = std::clamp(first, 0, size);
    const int to = std::clamp(first + count, from, size);
    skipped_ = from - first;
    points_ = std::span(points).subspan(static_cast<std::size_t>(from),
                                        static_cast<std::size_t>(to - from));
  }

  /// Adds material from `low` to `high`: bits of the points in it by more than `slack`, and of
  /// those nearer to an end.
  void add(double low, double high, double slack, std::uint64_t& inside,
           std::uint64_t& at_end) const {
    if (points_.empty() || high + slack < points_.front() || low - slack > points_.back()) return;
    const int from = first_above(low + slack);
    const int to = std::max(from, first_at(high - slack));
    inside |= bit_run(from, to);
    at_end |= bit_run(first_at(low - slack), from) | bit_run(to, first_above(high + slack));
  }

 private:
  [[nodiscard]] int first_above(double at) const {
    return skipped_ +
           static_cast<int>(std::upper_bound(points_.begin(), points_.end(), at) - points_.begin());
  }
  [[nodiscard]] int first_at(double at) const {
    return skipped_ +
           static_cast<int>(std::lower_bound(points_.begin(), points_.end(), at) - points_.begin());
  }

  std::span<const double> points_;
  int skipped_ = 0;
};

/// Words along X, (j, k) with j first, as words along Z, (i, j) with i first.
[[nodiscard]] std::vector<std::uint64_t> turned_from_x(const std::vector<std::uint64_t>& words,
                                                       Place count);
/// Words along Y, (k, i) with k first, likewise.
[[nodiscard]] std::vector<std::uint64_t> turned_from_y(const std::vector<std::uint64_t>& words,
                                                       Place count);

}  // namespace kerf::stock::surface
