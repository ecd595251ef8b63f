#include "motion/motion_extent.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/arc.hpp"
#include "motion/plane_axes.hpp"
#include "motion/space_arc_path.hpp"
#include "motion/surface_path.hpp"
#include "motion/turning_rapid.hpp"

namespace kerf::motion {
namespace {

using base::TipPoint;
using geometry::Vec2;
using geometry::Vec3;

// The quadrant points that an arc passes.
void reach_quadrants(const AxisSetup& axes, const TipPoint& at, const Arc& arc,
                     MotionExtent& extent) {
  const auto plane = plane_axes(arc.plane, axes);
  if (!plane) return;
  const bool clockwise = arc.direction == Direction::clockwise;
  const Vec2 from = plane->project(at);
  const Vec2 to = plane->project(arc.to);
  const Vec2 centre{arc.center[0], arc.center[1]};
  const double sweep =
      arc.turns > 0 ? 2 * std::numbers::pi : geometry::sweep_rad(from, to, centre, clockwise);
  const double radius = std::max(geometry::length(from - centre), geometry::length(to - centre));
  constexpr Vec2 kQuadrants[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const Vec2 quadrant : kQuadrants) {
    const Vec2 point = centre + radius * quadrant;
    if (point == from || geometry::sweep_rad(from, point, centre, clockwise) > sweep) continue;
    TipPoint reached = arc.to;
    reached[plane->first] = point.u;
    reached[plane->second] = point.v;
    extent.reach(reached);
  }
}

// Where the circle goes farthest along X, Y and Z. The other axes have their extremes at the points
// given.
void reach_farthest(const AxisSetup& axes, const SpaceArcPath& path, MotionExtent& extent) {
  for (const auto& knot : path.knots().subspan(1)) extent.reach(knot.point);
  constexpr Vec3 kDirections[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                  {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  for (const Vec3 direction : kDirections) {
    const double angle = path.circle().farthest_rad(direction);
    if (angle <= 0 || angle >= path.circle().sweep_rad()) continue;
    TipPoint reached = path.at(angle);
    for (std::size_t i = 0; i < axes.count(); ++i) {
      if (axes.axes[i].rotary) reached.values[i] = path.knots().back().point.values[i];
    }
    extent.reach(reached);
  }
}

// Where an axis turns round between two places of a curve: once at most, where its rate is 0.
void reach_turn(const Curve& curve, base::Axis axis, double low, double high,
                MotionExtent& extent) {
  const auto rate = [&](double s) { return curve.rate(s)[axis]; };
  if (!(rate(low) * rate(high) < 0)) return;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (rate(low) * rate(middle) <= 0 ? high : low) = middle;
  }
  extent.reach(curve.at(low));
}

// The ends of its curves, and of each the place where it is nearest to the centre or farthest away.
void reach_on_surface(const AxisSetup& axes, const TipPoint& from, const SurfaceMove& move,
                      MotionExtent& extent) {
  const SurfacePath path(axes, from, move, [&](const Curve& curve) {
    extent.reach(curve.end());
    reach_turn(curve, move.surface.first, 0, curve.length(), extent);
  });
}

// Its direction turns at most twice as far as the work, so in a sixteenth of half a turn X and Y
// turn round once at most.
void reach_on_spiral(const AxisSetup& axes, const TurningRapid& way, MotionExtent& extent) {
  constexpr int kParts = 16;
  const Curve curve = way.curve();
  for (int i = 0; i < kParts; ++i) {
    for (const char letter : {'X', 'Y'}) {
      reach_turn(curve, *axes.find(letter), curve.length() * i / kParts,
                 curve.length() * (i + 1) / kParts, extent);
    }
  }
}

}  // namespace

void MotionExtent::reach(const TipPoint& point) {
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    low.values[i] = std::min(low.values[i], point.values[i]);
    high.values[i] = std::max(high.values[i], point.values[i]);
  }
}

MotionExtent extent_of(const AxisSetup& axes, const TipPoint& from, const Motion& motion) {
  const TipPoint& to = *target_of(motion);
  MotionExtent extent{to, to};
  if (const auto* const arc = std::get_if<Arc>(&motion.action))
    reach_quadrants(axes, from, *arc, extent);
  if (const auto* const arc = std::get_if<SpaceArc>(&motion.action))
    reach_farthest(axes, SpaceArcPath(axes, from, *arc), extent);
  if (const auto* const move = std::get_if<SurfaceMove>(&motion.action))
    reach_on_surface(axes, from, *move, extent);
  if (axes.turning_work && std::holds_alternative<Rapid>(motion.action)) {
    if (const auto way = TurningRapid::between(axes, from, to)) reach_on_spiral(axes, *way, extent);
  }
  return extent;
}

}  // namespace kerf::motion
