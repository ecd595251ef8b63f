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

TipInSpace::TipInSpace(const motion::AxisSetup& axes) {
  constexpr std::array<char, 3> kLetters{'X', 'Y', 'Z'};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = axes.find(kLetters[i]);
    if (axis && !axes[*axis].rotary) from_[i] = axis;
  }
}

Point3 TipInSpace::point_of(const base::TipPoint& tip, const Point3& otherwise) const {
  Point3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = from_[i] ? drawable(tip[*from_[i]], otherwise[i]) : 0;
  }
  return point;
}

}  // namespace kerf::output::plot
