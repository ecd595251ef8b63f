#pragma once

namespace kerf::planner {

/// A stretch of time with constant jerk along the path. mm (or degrees) and seconds.
struct Phase {
  double duration_s = 0;
  double velocity = 0;  ///< at its begin
  double acceleration = 0;
  double jerk = 0;

  /// Way, speed and acceleration `t_s` after its begin, 0 <= t_s <= duration_s.
  [[nodiscard]] double way(double t_s) const {
    return t_s * (velocity + t_s * (acceleration / 2 + t_s * jerk / 6));
  }
  [[nodiscard]] double velocity_at(double t_s) const {
    return velocity + t_s * (acceleration + t_s * jerk / 2);
  }
  [[nodiscard]] double acceleration_at(double t_s) const { return acceleration + t_s * jerk; }
};

}  // namespace kerf::planner
