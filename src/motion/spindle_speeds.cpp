#include "motion/spindle_speeds.hpp"

#include <cmath>
#include <utility>

#include "motion/spindle_speed.hpp"

namespace kerf::motion {

using base::TipPoint;

double SpindleSpeeds::signed_rpm(const Spindle& spindle, const TipPoint& tip) const {
  if (!spindle.turns()) return 0;
  const double rpm = rpm_at(spindle, tip) * override_;
  return spindle.turning == Spindle::Turning::counterclockwise ? -rpm : rpm;
}

SpindleTurn SpindleSpeeds::command(const Spindle& spindle, const TipPoint& tip) {
  spindles_.take(spindle);
  if (acceleration_of(spindle) > 0) return change(spindle, tip);
  constexpr double kNotKnown = -1;
  const double speed = spindle.follows_radius() ? kNotKnown : spindle.known_rpm();
  return {spindle.turns() ? speed : 0, 0, spindle.name};
}

SpindleTurn SpindleSpeeds::change(const Spindle& spindle, const TipPoint& tip) {
  Speed& speed = speeds_[index(spindle.name)];
  const double rpm = signed_rpm(spindle, tip);
  const double ramp_s = std::fabs(rpm - speed.rpm) / acceleration_of(spindle);
  if (ramp_s > 0 || rpm == 0) speed.arrival_s = rpm == 0 ? 0 : ramp_s;
  speed.rpm = rpm;
  return {rpm, acceleration_of(spindle), spindle.name};
}

std::optional<SpindleTurn> SpindleSpeeds::go_fast_to(const TipPoint& tip) {
  const Spindle& spindle = of_feed();
  if (!spindle.follows_radius() || acceleration_of(spindle) <= 0) return std::nullopt;
  return change(spindle, tip);
}

void SpindleSpeeds::cut_to(const TipPoint& tip) {
  const Spindle& spindle = of_feed();
  if (spindle.follows_radius()) speeds_[index(spindle.name)].rpm = signed_rpm(spindle, tip);
}

std::optional<SpindleSpeeds::Arrival> SpindleSpeeds::next_arrival() {
  for (std::size_t i = 0; i < kSpindles; ++i) {
    const double most_s = std::exchange(speeds_[i].arrival_s, 0);
    if (most_s > 0) return Arrival{static_cast<SpindleName>(i), most_s};
  }
  return std::nullopt;
}

}  // namespace kerf::motion
