#include "planner/corner_time.hpp"

#include <algorithm>
#include <cmath>

#include "motion/axis_norms.hpp"

namespace kerf::planner {

using base::AxisVector;

namespace {

AxisVector larger(const AxisVector& a, const AxisVector& b) {
  AxisVector result;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    result.values[m] = std::max(std::fabs(a.values[m]), std::fabs(b.values[m]));
  return result;
}

motion::AxisNorms norms(const CellLimits& limits) { return {limits.linear(), base::kMaxAxes}; }

}  // namespace

CornerTime::CornerTime(const CellLimits& limits, const RoundingShape& shape, const Side& in,
                       const Side& out)
    : limits_(limits),
      shape_(shape),
      curves_{larger(in.driven.first, out.driven.first),
              larger(in.driven.second, out.driven.second),
              larger(in.driven.third, out.driven.third)},
      curvature_(norms(limits).mm(larger(in.tip.second, out.tip.second))),
      turn_(larger(out.driven.first - in.driven.first, {})),
      bend_(larger(out.driven.second - in.driven.second, {})),
      turn_mm_(norms(limits).mm(out.tip.first - in.tip.first)),
      in_(drive_of(in)),
      out_(drive_of(out)) {}

CornerTime::Drive CornerTime::drive_of(const Side& side) const {
  CellBounds bounds;
  for (std::size_t m = 0; m < limits_.axes(); ++m)
    bounds.driven.first.values[m] = std::fabs(side.driven.first.values[m]);
  Drive drive{limits_.of(bounds, side.feed, CellLimits::Use::path),
              limits_.acceleration_along(side.driven.first), 0};
  drive.speed = reachable_speed(0, side.length / 2, drive.limits, drive.limits.velocity);
  return drive;
}

double CornerTime::Drive::lost_to_ramp_s(double corner_speed) const {
  if (corner_speed >= speed) return 0;
  return ramp_time_s(corner_speed, speed, limits) * (speed - corner_speed) / (2 * speed);
}

double CornerTime::speed_of(double reach) const {
  CellBounds bounds{.driven = curves_,
                    .curvature = curvature_ + shape_.second / reach * turn_mm_,
                    .tip_acceleration = std::max(in_.acceleration, out_.acceleration),
                    .at_border = true};
  for (std::size_t m = 0; m < limits_.axes(); ++m) {
    const double turn = turn_.values[m] / reach;
    bounds.driven.second.values[m] += shape_.second * turn;
    bounds.driven.third.values[m] += shape_.third * (turn + bend_.values[m]) / reach;
  }
  return limits_.highest_speed(bounds, CellLimits::Use::corner);
}

double CornerTime::at_speed_s(double reach, double speed) const {
  const double v = std::min({speed, in_.speed, out_.speed});
  const double there = 2 * reach / v - reach / in_.speed - reach / out_.speed;
  return there + in_.lost_to_ramp_s(v) + out_.lost_to_ramp_s(v);
}

double CornerTime::rounded_s(double reach) const { return at_speed_s(reach, speed_of(reach)); }

double CornerTime::rounded_s(const motion::Curve& rounding,
                             const motion::CurveBounds& bounds) const {
  const double length = rounding.length();
  const double curvature = rounding.curvature_bound(0, length, bounds, limits_.linear());
  return at_speed_s(length / 2, limits_.highest_speed(
                                    {.driven = bounds, .curvature = curvature, .at_border = true},
                                    CellLimits::Use::corner));
}

double CornerTime::stopped_s() const {
  return in_.lost_to_ramp_s(0) + out_.lost_to_ramp_s(0) + limits_.period_s() / 2;
}

}  // namespace kerf::planner
