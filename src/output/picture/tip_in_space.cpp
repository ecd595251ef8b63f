#include "output/picture/tip_in_space.hpp"

#include <cmath>

#include "output/picture/internal/path_store.hpp"

namespace kerf::output::plot {
namespace {

double drawable(double value, double otherwise) {
  constexpr double kFarthest = PathStore::kLargestCoordinate;
  if (std::abs(value) <= kFarthest) return value;
  if (!std::isfinite(value)) return otherwise;
  return value > 0 ? kFarthest : -kFarthest;
}

}  // namespace

TipInSpace::TipInSpace(const motion::AxisSetup& axes, double x_scale) {
  constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = axes.find(kLetters[i]);
    if (axis && !axes[*axis].rotary) from_[i] = {base::index(*axis), i == kX ? x_scale : 1};
  }
}

Point3 TipInSpace::point_of(const base::TipPoint& tip, const Point3& otherwise) const {
  Point3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    const Coordinate& from = from_[i];
    point[i] = from.scale == 0 ? 0 : drawable(tip.values[from.axis] * from.scale, otherwise[i]);
  }
  return point;
}

}  // namespace kerf::output::plot
