#pragma once

#include <cstdint>
#include <limits>

#include "base/axes.hpp"

namespace kerf::motion {

/// What the driven axes can do, in the order of the machine file. mm or degrees and seconds.
struct AxisLimits {
  base::AxisVector velocity;      ///< > 0
  base::AxisVector acceleration;  ///< > 0
  base::AxisVector jerk;          ///< > 0; infinite: the axis has no such limit
};

/// How set-points follow from the path.
enum class Sampling : std::uint8_t {
  planned,     ///< along a plan that keeps every limit of every axis
  tail,        ///< constant feed, no acceleration; the last step of a motion is what remains
  equal,       ///< constant feed, no acceleration; all steps of a motion are equal
  equal_steps  ///< points at equal steps of the path, not of time
};

/// What the interpolator of a machine does.
struct Settings {
  double period_s = 0.001;            ///< of the servo, > 0
  double tolerance_mm = 0.01;         ///< most that a rounded corner leaves the path; 0: stop there
  double chord_tolerance_mm = 0.001;  ///< most that the tip leaves the path within a period, > 0
  Sampling sampling = Sampling::planned;
  double step_mm = 1;  ///< with equal_steps, > 0
};

}  // namespace kerf::motion
