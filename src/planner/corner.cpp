#include "planner/corner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::planner {
namespace {

using base::AxisVector;

// Directions that differ by less are the same: at 1 m/s a step of 1e-12 m/s.
constexpr double kSameDirection = 1e-12;
// A rounding takes this share of what is possible at the feed, so that something remains for
// speeding up and slowing down.
constexpr double kShareOfLimit = 0.5;
// The deviation is asked at some places; between them it may be this much more. What is meant to
// reach it must stay below by more than rounding.
constexpr double kBetween = 0.98;
constexpr double kBelow = 1 - 1e-6;

constexpr RoundingShape kParabola{0.5, 0, 1.0 / 4};
constexpr RoundingShape kQuintic{0.75, 1.5, 3.0 / 16};

// What there is to speed up and slow down. A smooth curve is mostly a part of many.
double room_of(const motion::Curve& curve) {
  constexpr double kMany = 4;
  return curve.is_line() || curve.is_arc() ? curve.length() : kMany * curve.length();
}

// The reach, at most `most`, with which the corner takes the least time, which has one valley. Much
// shorter ones are hardly faster than a stop.
double best_reach(const CornerTime& time, double most) {
  constexpr int kMostHalvings = 4;
  double least = time.rounded_s(most);
  double reach = most;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double shorter = time.rounded_s(reach / 2);
    if (shorter >= least) break;
    least = shorter;
    reach /= 2;
  }
  return reach;
}

}  // namespace

// Reach with which neither the turn nor the step of the second derivative asks more than the share
// of acceleration and jerk at the feed.
double CornerRounder::wanted_reach(const base::JointJet& end, const base::JointJet& begin,
                                   const Passage& passage) const {
  const AxisLimits& axis = limits_.axis_limits();
  const AxisVector turn = begin.first - end.first;
  const AxisVector bend = begin.second - end.second;
  double v = std::min(passage.feed_in, passage.feed_out);
  for (std::size_t m = 0; m < limits_.axes(); ++m) {
    const double d = std::fabs(turn.values[m]);
    // No axis can follow a turn faster than this.
    if (d > 0) v = std::min(v, 2 * axis.velocity.values[m] / d);
  }
  const bool with_jerk = limits_.jerk_limited();
  const RoundingShape& shape = with_jerk ? kQuintic : kParabola;
  double reach = 0;
  for (std::size_t m = 0; m < limits_.axes(); ++m) {
    const double d = std::fabs(turn.values[m]);
    if (d > 0)
      reach =
          std::max(reach, shape.second * d * v * v / (kShareOfLimit * axis.acceleration.values[m]));
    if (!with_jerk) continue;
    const double j = kShareOfLimit * axis.jerk.values[m];
    if (d > 0) reach = std::max(reach, std::sqrt(shape.third * d * v * v * v / j));
    const double b = std::fabs(bend.values[m]);
    if (b > 0) reach = std::max(reach, shape.third * b * v * v * v / j);
  }
  return reach;
}

// Both curves begin and end like the rounding, in place and direction, and bend by so much at most:
// what it leaves them by grows from either end to reach²/2 of what their second derivatives differ
// by, or less.
bool CornerRounder::is_surely_near(const Rounding& rounding, const motion::CurveBounds& bounds,
                                   const motion::Curve& in, const motion::Curve& out,
                                   double tolerance) const {
  constexpr double kSurely = 1 - 1e-7;
  const double reach = rounding.reach;
  const double bend =
      std::max(bend_of(in, in.length() - reach, in.length()), bend_of(out, 0, reach));
  return reach * reach / 2 * (norms_.larger(bounds.second) + bend) <=
         kSurely * kBetween * tolerance;
}

double CornerRounder::bend_of(const motion::Curve& curve, double from, double to) const {
  if (curve.is_line()) return 0;
  if (curve.is_arc()) return curve.curvature_bound(from, to, {}, norms_.linear);
  return norms_.larger(curve.bounds(from, to).second);
}

// Asked at some places; the deviation has one hill, so it is little more between them.
bool CornerRounder::stays_near(const Rounding& rounding, const motion::Curve& in,
                               const motion::Curve& out, double tolerance) const {
  constexpr int kPlaces = 16;
  for (int i = 1; i < kPlaces; ++i) {
    const double s = rounding.curve.length() * i / kPlaces;
    const AxisVector programmed =
        s < rounding.reach ? in.at(in.length() - rounding.reach + s) : out.at(s - rounding.reach);
    if (norms_.larger(rounding.curve.at(s) - programmed) > kBetween * tolerance) return false;
  }
  return true;
}

// With limited jerk also the curvature must go on.
Rounding CornerRounder::round(const motion::Curve& in, const motion::Curve& out,
                              double reach) const {
  const base::TipJet from = in.jet(in.length() - reach);
  const base::TipJet to = out.jet(reach);
  return {reach, limits_.jerk_limited() ? motion::Curve::hermite(from, to, 2 * reach, axes_)
                                        : motion::Curve::cubic(from, to, 2 * reach, axes_)};
}

Corner CornerRounder::between(const motion::Curve& in, const motion::Curve& out,
                              const Passage& passage) const {
  const base::TipJet end = in.jet(in.length());
  const base::TipJet begin = out.jet(0);
  const double angle = norms_.larger(begin.first - end.first);
  const double bend = limits_.jerk_limited() ? norms_.larger(begin.second - end.second) : 0;
  if (angle < kSameDirection && bend < kSameDirection) return {};
  const auto driven_end = follower_.driven(end);
  const auto driven_begin = follower_.driven(begin);
  if (passage.tolerance_mm <= 0 || !driven_end || !driven_begin) return {Corner::Kind::sharp, {}};
  const RoundingShape& shape = limits_.jerk_limited() ? kQuintic : kParabola;
  double reach = std::min(wanted_reach(*driven_end, *driven_begin, passage), passage.most_reach);
  if (angle > 0)
    reach = std::min(reach, kBelow * kBetween * passage.tolerance_mm / (shape.deviation * angle));
  const CornerTime time(limits_, shape, {end, *driven_end, room_of(in), passage.feed_in},
                        {begin, *driven_begin, room_of(out), passage.feed_out});
  return best_of(in, out, time, best_reach(time, reach), passage.tolerance_mm);
}

// The first that can be driven, lies near enough, and takes no longer than a stop.
Corner CornerRounder::best_of(const motion::Curve& in, const motion::Curve& out,
                              const CornerTime& time, double reach, double tolerance) const {
  constexpr int kMostTries = 30;
  constexpr double kShrink = 0.75;
  const double most_s = std::isfinite(tolerance) ? time.stopped_s() : kInfinite;
  for (int i = 0; i < kMostTries; ++i, reach *= kShrink) {
    const Rounding rounding = round(in, out, reach);
    const motion::CurveBounds bounds = rounding.curve.bounds(0, rounding.curve.length());
    if (!is_surely_near(rounding, bounds, in, out, tolerance) &&
        !stays_near(rounding, in, out, tolerance))
      continue;
    if (!follower_.can_follow(rounding.curve)) continue;
    const double time_s =
        follower_.linked() ? time.rounded_s(reach) : time.rounded_s(rounding.curve, bounds);
    if (time_s <= most_s) return {Corner::Kind::rounded, rounding};
  }
  return {Corner::Kind::sharp, {}};
}

}  // namespace kerf::planner
