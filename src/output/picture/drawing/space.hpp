#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace kerf::output::plot {

/// X, Y, Z in mm, machine coordinates.
using Point3 = std::array<double, 3>;
inline constexpr std::size_t kX = 0;
inline constexpr std::size_t kY = 1;
inline constexpr std::size_t kZ = 2;

inline Point3 operator-(const Point3& a, const Point3& b) {
  return {a[kX] - b[kX], a[kY] - b[kY], a[kZ] - b[kZ]};
}

/// Smallest box along the axes around the points added; empty at first.
class Box3 {
 public:
  void add(const Point3& point) {
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], point[i]);
      high_[i] = std::max(high_[i], point[i]);
    }
  }

  [[nodiscard]] bool empty() const { return low_[kX] > high_[kX]; }
  // Of a box that is not empty:
  [[nodiscard]] const Point3& low() const { return low_; }
  [[nodiscard]] const Point3& high() const { return high_; }
  [[nodiscard]] Point3 size() const { return high_ - low_; }
  [[nodiscard]] double largest_side() const { return std::ranges::max(size()); }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point3 low_{kInfinity, kInfinity, kInfinity};
  Point3 high_{-kInfinity, -kInfinity, -kInfinity};
};

}  // namespace kerf::output::plot
