#include "stock/cutting/sweep_maker.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

using base::TipPoint;
using motion::Curve;

// A move that nobody could follow is not divided without end.
constexpr double kMostSteps = 100000;

/// How often a curve is divided so that no chord leaves it by more than `tolerance`. Over a step of
/// 1/n a point at the lever L from where the work turns about leaves it by no more than
///
///   (L φ² + 2 φ d + k d²) / 8 n²,   φ all turns together, d the tip's way, k its curvature
double steps_of(const Curve& curve, double turn_rad, double lever, double tolerance) {
  motion::LinearAxes all{};
  all.fill(true);
  const double way = curve.length();
  const double bend = curve.curvature_bound(0, way, curve.bounds(0, way), all);
  const double sum = lever * turn_rad * turn_rad + 2 * turn_rad * way + bend * way * way;
  return std::clamp(std::ceil(std::sqrt(sum / (8 * tolerance))), 1.0, kMostSteps);
}

}  // namespace

void SweepMaker::add(const TipPoint& from, const Curve& curve, const Sweep& like, double reach_mm,
                     std::vector<Sweep>& sweeps) const {
  if (frame_.turns_between(from, curve.end()) || curve.is_on_face()) {
    add_turning(from, curve, like, reach_mm, sweeps);
    return;
  }
  Sweep sweep = like;
  sweep.axis = frame_.turned(like.axis, from);
  if (curve.is_line()) {
    sweep.way = StraightWay{frame_.pose(from).tip, frame_.pose(curve.end()).tip};
  } else if (curve.is_arc()) {
    sweep.way = arc_way(from, curve);
  } else {
    add_divided(curve, sweep, sweeps);
    return;
  }
  sweeps.push_back(sweep);
}

ArcWay SweepMaker::arc_way(const TipPoint& from, const Curve& curve) const {
  const motion::ArcShape shape = curve.arc_shape();
  const double length = curve.length();
  const auto way = [&](const base::AxisVector& v) {
    return frame_.turned(frame_.in_space(v), from);
  };
  return {frame_.pose(TipPoint(shape.origin)).tip,
          length * way(shape.slope),
          way(shape.e1),
          way(shape.e2),
          shape.radius,
          length * shape.radius_slope,
          shape.angle_rad,
          length * shape.rate};
}

void SweepMaker::add_divided(const Curve& curve, const Sweep& like,
                             std::vector<Sweep>& sweeps) const {
  const double steps = steps_of(curve, 0, 0, tolerance_mm_);
  Sweep sweep = like;
  Vec3 from = frame_.pose(curve.at(0)).tip;
  for (double i = 1; i <= steps; ++i) {
    const Vec3 to =
        frame_.pose(i == steps ? curve.end() : curve.at(curve.length() * i / steps)).tip;
    sweep.way = StraightWay{from, to};
    sweeps.push_back(sweep);
    from = to;
  }
}

void SweepMaker::add_turning(const TipPoint& from, const Curve& curve, const Sweep& like,
                             double reach_mm, std::vector<Sweep>& sweeps) const {
  const double lever = reach_mm + frame_.lever(from, curve.end());
  const double turn = frame_.turn_rad(from, curve.end());
  const double steps = steps_of(curve, turn, lever, tolerance_mm_);
  Sweep sweep = like;
  Pose at = frame_.pose(from, like.axis);
  for (double i = 1; i <= steps; ++i) {
    const Pose next =
        frame_.pose(i == steps ? curve.end() : curve.at(curve.length() * i / steps), like.axis);
    sweep.axis = at.axis;
    sweep.way = next.axis == at.axis ? Way(StraightWay{at.tip, next.tip})
                                     : Way(TurningWay{at.tip, next.tip, next.axis});
    sweeps.push_back(sweep);
    at = next;
  }
}

}  // namespace kerf::stock
