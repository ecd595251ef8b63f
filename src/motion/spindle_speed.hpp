#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/motion.hpp"

namespace kerf::motion {

/// Nearer to the spindle's axis a surface speed without a limit grows no further.
inline constexpr double kLeastRadius_mm = 0.01;

/// Radius times speed, mm rpm, at constant surface speed: 1000 S / (2 π).
[[nodiscard]] inline double radius_speed(const Spindle& spindle) {
  constexpr double kMillimetresPerMetre = 1000;
  return kMillimetresPerMetre * spindle.speed / (2 * std::numbers::pi);
}

/// At this radius and below the spindle has the speed that is its limit. Precondition:
/// follows_radius().
[[nodiscard]] inline double radius_of_limit(const Spindle& spindle) {
  const double limit = spindle.limit_rpm();
  return limit > 0 ? radius_speed(spindle) / limit : kLeastRadius_mm;
}

/// The speed while the tip is here, rpm; known_rpm() where that does not matter.
[[nodiscard]] inline double rpm_at(const Spindle& spindle, const base::TipPoint& tip) {
  if (!spindle.follows_radius()) return spindle.known_rpm();
  const double radius = std::fabs(tip[*spindle.radius_axis] - spindle.centre);
  return radius_speed(spindle) / std::max(radius, radius_of_limit(spindle));
}

}  // namespace kerf::motion
