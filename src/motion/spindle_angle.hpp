#pragma once

#include <cmath>

namespace kerf::motion {

/// Where the spindle stands at a time: it turns from its mark on, and changes its speed at once.
class SpindleAngle {
 public:
  /// From `time_s` on. A negative speed is not known: it is that of who asks.
  void set_speed(double rpm, double time_s) {
    turns_ = turns_at(time_s, 0);
    rpm_ = rpm;
    since_s_ = time_s;
  }
  /// Turns behind the mark, if it has had `rpm` where no speed was known.
  [[nodiscard]] double turns_at(double time_s, double rpm) const {
    const double turns = turns_ + (rpm_ < 0 ? rpm : rpm_) / 60 * (time_s - since_s_);
    return turns - std::floor(turns);
  }
  /// Until it is `angle_deg` behind the mark, at `rpm` > 0 from now on: less than a turn.
  [[nodiscard]] double seconds_until(double angle_deg, double time_s, double rpm) const {
    constexpr double kNow = 1 - 1e-9;  // by rounding only it has just passed
    const double turns = angle_deg / 360 - turns_at(time_s, rpm);
    const double left = turns - std::floor(turns);
    return left < kNow ? left * 60 / rpm : 0;
  }

 private:
  double turns_ = 0;
  double rpm_ = 0;
  double since_s_ = 0;
};

}  // namespace kerf::motion
