#include "drive/fast_profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::drive {

FastProfile::FastProfile(const FastRamp& ramp, std::int64_t pulses)
    : ramp_(ramp), pulses_(static_cast<double>(pulses)) {
  assert(pulses >= 1 && ramp.start_hz > 0 && ramp.start_hz <= ramp.rate_hz);
  assert(ramp.acceleration_hz_s > 0);
  const double start_squared = ramp.start_hz * ramp.start_hz;
  peak_hz_ = std::min(ramp.rate_hz, std::sqrt(start_squared + ramp.acceleration_hz_s * pulses_));
  ramp_pulses_ = (peak_hz_ * peak_hz_ - start_squared) / (2 * ramp.acceleration_hz_s);
  duration_s_ = 2 * ramp_time_s(ramp_pulses_) + (pulses_ - 2 * ramp_pulses_) / peak_hz_;
}

// Time to go `way` from the start: the root of start * t + a/2 * t² = way that loses no digits.
double FastProfile::ramp_time_s(double way) const {
  const double root =
      std::sqrt(ramp_.start_hz * ramp_.start_hz + 2 * ramp_.acceleration_hz_s * way);
  return 2 * way / (ramp_.start_hz + root);
}

double FastProfile::edge_s(std::int64_t number) const {
  const double way = static_cast<double>(number) / 2;
  const double left = pulses_ - way;
  if (way <= ramp_pulses_) return ramp_time_s(way);
  if (left <= ramp_pulses_) return duration_s_ - ramp_time_s(left);
  return ramp_time_s(ramp_pulses_) + (way - ramp_pulses_) / peak_hz_;
}

// Both ramps have the same way, and the one at the end begins behind `way`.
std::int64_t FastProfile::fewest_pulses(double way) const {
  const double fewest = std::ceil(way + std::min(way, ramp_pulses_));
  return static_cast<std::int64_t>(std::clamp(fewest, 1.0, pulses_));
}

}  // namespace kerf::drive
