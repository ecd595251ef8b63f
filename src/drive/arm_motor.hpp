#pragma once

#include <cmath>

namespace kerf::drive {

// Speeds of the arm's motors and tool (docs/drives.md, "The arm's timers").

inline constexpr double kDegreesPerRadian = 57.295779513082320877;

/// A step motor behind a gear.
struct ArmMotor {
  double step_deg = 0.75;   ///< of the motor's shaft
  double gear_ratio = 150;  ///< turns of the motor for one of the joint

  /// Angle of the joint for one pulse.
  [[nodiscard]] double joint_step_deg() const { return step_deg / gear_ratio; }

  /// Speed of the shaft, degrees/s, when a tool `radius_mm` from the joint moves at `speed_mm_s`.
  [[nodiscard]] double shaft_deg_s(double speed_mm_s, double radius_mm) const {
    return gear_ratio * speed_mm_s / radius_mm * kDegreesPerRadian;
  }
  /// Pulses per second at a speed of the shaft.
  [[nodiscard]] double rate_hz(double shaft_deg_s) const { return shaft_deg_s / step_deg; }
};

/// The line toggles twice a pulse.
inline double half_period_s(double rate_hz) { return 1 / (2 * rate_hz); }

/// Speed of a point `radius_mm` from a joint that turns.
inline double speed_at_radius_mm_s(double radius_mm, double joint_deg_s) {
  return radius_mm * joint_deg_s / kDegreesPerRadian;
}

}  // namespace kerf::drive
