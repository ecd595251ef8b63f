#include "motion/space_arc_path.hpp"

#include <cassert>

namespace kerf::motion {
namespace {

using base::Axis;
using base::TipPoint;
using geometry::Vec3;
using Xyz = std::array<std::optional<Axis>, 3>;

Vec3 project(const TipPoint& point, const Xyz& xyz) {
  const auto value = [&](const std::optional<Axis>& axis) { return axis ? point[*axis] : 0; };
  return {value(xyz[0]), value(xyz[1]), value(xyz[2])};
}

void place(TipPoint& point, const Xyz& xyz, Vec3 at) {
  const std::array<double, 3> values{at.x, at.y, at.z};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (xyz[i]) point[*xyz[i]] = values[i];
  }
}

geometry::SpaceArc circle_of(const TipPoint& from, const SpaceArc& arc, const Xyz& xyz) {
  using geometry::SpaceArc;
  const Vec3 begin = project(from, xyz);
  const Vec3 via = project(arc.via, xyz);
  const auto found = arc.full_circle ? SpaceArc::circle(begin, via, project(arc.second_via, xyz))
                                     : SpaceArc::through(begin, via, project(arc.to, xyz));
  assert(found);
  return *found;
}

}  // namespace

SpaceArcPath::SpaceArcPath(const AxisSetup& axes, const TipPoint& from, const SpaceArc& arc)
    : xyz_{axes.find('X'), axes.find('Y'), axes.find('Z')}, circle_(circle_of(from, arc, xyz_)) {
  const auto pass = [this](double angle_rad, const TipPoint& point) {
    knots_[knot_count_++] = {angle_rad, point};
  };
  pass(0, from);
  pass(circle_.to_second_rad(), arc.via);
  if (arc.full_circle) pass(circle_.to_third_rad(), arc.second_via);
  pass(circle_.sweep_rad(), arc.to);
}

TipPoint SpaceArcPath::at(double angle_rad) const {
  const auto passed = knots();
  if (angle_rad <= 0) return passed.front().point;
  const auto next = std::find_if(passed.begin(), passed.end(),
                                 [&](const Knot& knot) { return angle_rad <= knot.angle_rad; });
  if (next == passed.end()) return passed.back().point;
  if (angle_rad == next->angle_rad) return next->point;
  const Knot& before = *std::prev(next);
  const double share = (angle_rad - before.angle_rad) / (next->angle_rad - before.angle_rad);
  TipPoint point = before.point;
  for (std::size_t i = 0; i < base::kMaxAxes; ++i)
    point.values[i] += share * (next->point.values[i] - before.point.values[i]);
  place(point, xyz_, circle_.at(angle_rad));
  return point;
}

}  // namespace kerf::motion
