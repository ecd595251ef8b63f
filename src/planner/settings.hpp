#pragma once

#include <cstdint>
#include <limits>

#include "base/axes.hpp"

namespace kerf::planner {

/// No limit, no end.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// What the driven axes can do, in the order of the machine file. mm or degrees and seconds.
struct AxisLimits {
  base::AxisVector velocity;      ///< > 0
  base::AxisVector acceleration;  ///< > 0
  base::AxisVector jerk;          ///< > 0; infinite: the axis has no such limit
};

/// How set-points follow from the path (docs/motion.md, "Sampling"). All but the first know neither
/// acceleration nor rounded corners.
enum class Sampling : std::uint8_t {
  planned,      ///< along a plan that keeps every limit of every axis
  tail,         ///< constant feed; the last step of a motion is what remains
  equal,        ///< constant feed; all steps of a motion are equal
  equal_steps,  ///< points at equal steps of the path, not of time
  literal       ///< likewise, but X Y and Z of a line step apart: to compare and to teach
};

/// Whether there is a point for every period of the servo.
[[nodiscard]] constexpr bool is_periodic(Sampling sampling) {
  return sampling != Sampling::equal_steps && sampling != Sampling::literal;
}

/// What the interpolator of a machine does.
struct Settings {
  double period_s = 0.001;            ///< of the servo, > 0
  double tolerance_mm = 0.01;         ///< most that a rounded corner leaves the path; 0: stop there
  double chord_tolerance_mm = 0.001;  ///< most that the tip leaves the path within a period, > 0
  Sampling sampling = Sampling::planned;
  double step_mm = 1;  ///< with equal_steps and literal, > 0
};

}  // namespace kerf::planner
