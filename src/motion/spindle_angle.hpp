#pragma once

#include <algorithm>
#include <cmath>

namespace kerf::motion {

/// Where the spindle stands at a time: it turns from its mark on, and its angle counts up in either
/// direction. A change of its speed takes no time, or is even.
class SpindleAngle {
 public:
  /// It has this speed from `time_s` on. A negative speed is not known: it is that of who asks.
  void set_speed(double rpm, double time_s) {
    turns_ = turns_at(time_s, 0);
    is_known_ = rpm >= 0;
    from_rpm_ = to_rpm_ = is_known_ ? rpm : 0;
    since_s_ = time_s;
    ramp_s_ = 0;
  }
  /// From `time_s` on it goes to this speed, by `acceleration` > 0 rpm/s; negative speeds are those
  /// of the other direction.
  void ramp_to(double rpm, double time_s, double acceleration) {
    const double from_rpm = speed_at(time_s);
    turns_ = turns_at(time_s, 0);
    is_known_ = true;
    from_rpm_ = from_rpm;
    to_rpm_ = rpm;
    since_s_ = time_s;
    ramp_s_ = std::fabs(rpm - from_rpm) / acceleration;
  }
  /// Turns behind the mark, if it has had `rpm` where no speed was known.
  [[nodiscard]] double turns_at(double time_s, double rpm) const {
    const double passed_s = time_s - since_s_;
    const double ramped_s = std::min(passed_s, ramp_s_);
    const double final_rpm = is_known_ ? std::fabs(to_rpm_) : rpm;
    const double mean_rpm = (std::fabs(from_rpm_) + std::fabs(speed_at(time_s))) / 2;
    const double turns = turns_ + mean_rpm / 60 * ramped_s + final_rpm / 60 * (passed_s - ramped_s);
    return turns - std::floor(turns);
  }
  /// Until it has its speed; 0: it has.
  [[nodiscard]] double seconds_to_speed(double time_s) const {
    return std::max(since_s_ + ramp_s_ - time_s, 0.0);
  }
  /// Until it is `angle_deg` behind the mark, at `rpm` > 0 from now on: less than a turn.
  [[nodiscard]] double seconds_until(double angle_deg, double time_s, double rpm) const {
    constexpr double kNow = 1 - 1e-9;  // by rounding only it has just passed
    const double turns = angle_deg / 360 - turns_at(time_s, rpm);
    const double left = turns - std::floor(turns);
    return left < kNow ? left * 60 / rpm : 0;
  }

 private:
  // Of a known speed.
  [[nodiscard]] double speed_at(double time_s) const {
    const double left_s = seconds_to_speed(time_s);
    return left_s > 0 ? to_rpm_ + (from_rpm_ - to_rpm_) * left_s / ramp_s_ : to_rpm_;
  }

  double turns_ = 0;
  bool is_known_ = true;
  double from_rpm_ = 0;
  double to_rpm_ = 0;
  double since_s_ = 0;
  double ramp_s_ = 0;
};

}  // namespace kerf::motion
