#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "motion/setpoint.hpp"

namespace kerf::machine {

/// The last points of a run: where the tool is, how fast, and how that changes.
class LatestPoints {
 public:
  void take(const motion::Setpoint& point) { points_[count_++ % points_.size()] = point; }

  /// Two runs with as many points do the same now.
  friend bool operator==(const LatestPoints& a, const LatestPoints& b) {
    return a.count_ == b.count_ &&
           std::equal(a.points_.begin(), a.points_.end(), b.points_.begin(), is_same);
  }

 private:
  // Rounding makes this much of a difference: a chain of lines that ends elsewhere, mm and degrees.
  static constexpr double kSamePlace = 1e-9;

  static bool is_same(const motion::Setpoint& a, const motion::Setpoint& b) {
    return a.time_s == b.time_s && a.mark.motion == b.mark.motion &&
           std::equal(a.tip.values.begin(), a.tip.values.end(), b.tip.values.begin(),
                      [](double x, double y) { return std::fabs(x - y) <= kSamePlace; });
  }

  std::array<motion::Setpoint, 3> points_;
  std::uint64_t count_ = 0;
};

}  // namespace kerf::machine
