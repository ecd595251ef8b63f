#include "motion/move_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/arc.hpp"
#include "math/math.hpp"
#include "motion/plane_axes.hpp"
#include "motion/space_arc_path.hpp"
#include "motion/surface_path.hpp"
#include "motion/turning_rapid.hpp"

namespace kerf::motion {

using base::AxisVector;
using base::TipPoint;
using geometry::Vec2;

std::span<const Curve> MoveCurves::of(const TipPoint& from, const Motion& motion) {
  at_ = from;
  curves_.clear();
  if (const auto* const arc = std::get_if<Arc>(&motion.action)) {
    add_arc(*arc);
  } else if (const auto* const space_arc = std::get_if<SpaceArc>(&motion.action)) {
    add_space_arc(*space_arc);
  } else if (const auto* const surface_move = std::get_if<SurfaceMove>(&motion.action)) {
    add_surface_move(*surface_move);
  } else if (const auto* const rapid = std::get_if<Rapid>(&motion.action)) {
    add_rapid(*rapid);
  } else if (const TipPoint* const to = target_of(motion)) {
    add_line(*to);
  }
  return curves_;
}

void MoveCurves::add_rapid(const Rapid& rapid) {
  if (axes_.turning_work) {
    if (const auto way = TurningRapid::between(axes_, at_, rapid.to)) return add(way->curve());
  } else if (!rapid.linear) {
    add_legs(rapid.to);
  }
  add_line(rapid.to);
}

// Every axis goes at its own rate: the way is a leg for each that is done before the others.
void MoveCurves::add_legs(const TipPoint& to) {
  const TipPoint from = at_;
  std::array<double, base::kMaxAxes> done_s{};
  for (std::size_t m = 0; m < axes_.count(); ++m)
    done_s[m] = std::fabs(to.values[m] - from.values[m]) * 60 / axes_.axes[m].rapid_per_min;
  std::array<double, base::kMaxAxes> order = done_s;
  std::sort(order.begin(), order.end());
  for (const double time_s : order) {
    if (time_s >= order.back()) return;
    TipPoint end = to;
    for (std::size_t m = 0; m < axes_.count(); ++m) {
      if (done_s[m] > time_s)
        end.values[m] = from.values[m] + (to.values[m] - from.values[m]) * (time_s / done_s[m]);
    }
    add_line(end);
  }
}

// Its parameter is the length of the linear axes, or of the rotary ones where these alone move.
void MoveCurves::add_line(const TipPoint& to) {
  const AxisVector way = to - at_;
  const double linear = norms_.mm(way);
  const double length = linear > 0 ? linear : norms_.degrees(way);
  if (length > 0) add(Curve::line(at_, to, length, axes_.count()));
}

void MoveCurves::add_arc(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const Vec2 centre{arc.center[0], arc.center[1]};
  const Vec2 from = plane->project(at_);
  const Vec2 to = plane->project(arc.to);
  const bool clockwise = arc.direction == Direction::clockwise;
  const double sweep =
      geometry::sweep_rad(from, to, centre, clockwise) + 2 * std::numbers::pi * arc.turns;
  const double start_radius = geometry::length(from - centre);
  const double end_radius = geometry::length(to - centre);
  const double length = sweep * (start_radius + end_radius) / 2;
  if (length == 0) return;
  ArcShape shape;
  shape.origin = at_;
  plane->place(shape.origin, centre);
  for (std::size_t m = 0; m < axes_.count(); ++m) {
    if (!plane->contains(base::Axis{static_cast<std::uint8_t>(m)}))
      shape.slope.values[m] = (arc.to.values[m] - at_.values[m]) / length;
  }
  shape.e1[plane->first] = 1;
  shape.e2[plane->second] = 1;
  shape.radius = start_radius;
  shape.radius_slope = (end_radius - start_radius) / length;
  shape.angle_rad = math::atan2(from.v - centre.v, from.u - centre.u);
  shape.rate = (clockwise ? -sweep : sweep) / length;
  add(Curve::arc(shape, arc.to, length, axes_.count()));
}

// At each of its points the rates of the rotary axes change.
void MoveCurves::add_space_arc(const SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  const geometry::SpaceArc& circle = path.circle();
  ArcShape shape;
  place(shape.origin, circle.centre());
  place(shape.e1, circle.e1());
  place(shape.e2, circle.e2());
  shape.radius = circle.radius();
  shape.rate = 1 / circle.radius();
  const auto knots = path.knots();
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double length = (knots[i].angle_rad - knots[i - 1].angle_rad) * circle.radius();
    shape.angle_rad = knots[i - 1].angle_rad;
    for (std::size_t m = 0; m < axes_.count(); ++m) {
      if (!axes_.axes[m].rotary) continue;
      shape.origin.values[m] = knots[i - 1].point.values[m];
      shape.slope.values[m] = (knots[i].point.values[m] - knots[i - 1].point.values[m]) / length;
    }
    add(Curve::arc(shape, knots[i].point, length, axes_.count()));
  }
}

void MoveCurves::add_surface_move(const SurfaceMove& move) {
  const TipPoint from = at_;
  const SurfacePath path(axes_, from, move, [this](const Curve& curve) { add(curve); });
}

void MoveCurves::add(const Curve& curve) {
  curves_.push_back(curve);
  at_ = curve.end();
}

void MoveCurves::place(AxisVector& vector, geometry::Vec3 xyz) const {
  if (const auto x = axes_.find('X')) vector[*x] = xyz.x;
  if (const auto y = axes_.find('Y')) vector[*y] = xyz.y;
  if (const auto z = axes_.find('Z')) vector[*z] = xyz.z;
}

}  // namespace kerf::motion
