#include "stock/saved/quarter_turn.hpp"

#include <algorithm>

namespace kerf::stock::saved {
namespace {

std::array<double, 3> parts_of(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace

std::optional<QuarterTurn> QuarterTurn::of(const Placing& placing) {
  if (!placing.is_square()) return std::nullopt;
  constexpr std::array<Vec3, 3> kAxes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  QuarterTurn turn;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::array<double, 3> along = parts_of(placing.turned(kAxes[axis]));
    for (std::size_t k = 0; k < 3; ++k) {
      if (along[k] == 0) continue;
      turn.to[axis] = static_cast<int>(k);
      turn.sign[axis] = along[k] > 0 ? 1 : -1;
    }
  }
  return turn;
}

int QuarterTurn::from(int axis) const {
  return static_cast<int>(std::find(to.begin(), to.end(), axis) - to.begin());
}

Bounds placed_box(const Bounds& box, const Placing& placing) {
  const Vec3 a = placing(box.low);
  const Vec3 b = placing(box.high);
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

}  // namespace kerf::stock::saved
