#pragma once

#include "motion/curve.hpp"
#include "planner/cell_limits.hpp"
#include "planner/profile.hpp"

namespace kerf::planner {

/// How a rounding bends: between lines whose directions differ by Δu its largest second derivative
/// is `second` |Δu| / reach, the third `third` |Δu| / reach², and it leaves the corner by
/// `deviation` |Δu| reach. A step of the second derivative adds `third` times it over reach.
struct RoundingShape {
  double second, third, deviation;
};

/// Estimates what a corner costs: the time beyond that of both curves at their own speed.
///
///     speed in ───╮              ╭─── speed out     rounded: slower over 2 reach, and the ramps
///                  ╲            ╱                    down to that speed and up again
///     at corner     ╰──────────╯                     stopped: the ramps to 0, and on average half
///                   ├─  2 reach ─┤                   of the period in which the axes come to rest
///
/// What lies beyond the two curves is not known; their speeds are those that a start and a stop at
/// their other ends allow.
class CornerTime {
 public:
  /// One of the two curves where they meet.
  struct Side {
    const base::TipJet& tip;
    const base::JointJet& driven;  ///< the same of the driven axes
    double length = 0;
    double feed = 0;
  };
  CornerTime(const CellLimits& limits, const RoundingShape& shape, const Side& in, const Side& out);

  [[nodiscard]] double rounded_s(double reach) const;
  /// Where the rounding is known: how fast its own curve can be driven is asked. `bounds` are those
  /// of all of it.
  [[nodiscard]] double rounded_s(const motion::Curve& rounding,
                                 const motion::CurveBounds& bounds) const;
  [[nodiscard]] double stopped_s() const;

 private:
  /// How fast one of the curves is driven.
  struct Drive {
    PathLimits limits;
    double acceleration = 0;  // along it at the corner, from rest
    double speed = 0;
    [[nodiscard]] double lost_to_ramp_s(double corner_speed) const;
  };
  [[nodiscard]] Drive drive_of(const Side& side) const;
  [[nodiscard]] double speed_of(double reach) const;
  [[nodiscard]] double at_speed_s(double reach, double speed) const;

  const CellLimits& limits_;
  RoundingShape shape_;
  motion::CurveBounds curves_;  // of both at the corner
  double curvature_ = 0;
  base::AxisVector turn_;
  base::AxisVector bend_;
  double turn_mm_ = 0;  // of the axes that count mm
  Drive in_, out_;
};

}  // namespace kerf::planner
