#include "stock/sweep/shorten.hpp"

namespace kerf::stock {
namespace {

/// The beginning of a way, up to t in (0, 1).
Way beginning(const Sweep& sweep, double t) {
  if (const auto* const straight = std::get_if<StraightWay>(&sweep.way))
    return part(*straight, 0, t);
  if (const auto* const arc = std::get_if<ArcWay>(&sweep.way)) return part(*arc, 0, t);
  const auto& turning = std::get<TurningWay>(sweep.way);
  const Vec3 axis = sweep.axis + t * (turning.to_axis - sweep.axis);
  return TurningWay{turning.from, point_at(turning, t), (1 / geometry::length(axis)) * axis};
}

}  // namespace

void shorten(std::vector<Sweep>& sweeps, std::size_t first, double share) {
  double way = 0;
  for (std::size_t i = first; i < sweeps.size(); ++i) way += length(sweeps[i].way);
  double rest = way * share;
  for (std::size_t i = first; i < sweeps.size(); ++i) {
    const double one = length(sweeps[i].way);
    if (rest >= one) {
      rest -= one;
      continue;
    }
    const double t = one > 0 ? rest / one : 0;
    if (t > 0) sweeps[i].way = beginning(sweeps[i], t);
    sweeps.resize(t > 0 ? i + 1 : i);
    return;
  }
}

}  // namespace kerf::stock
