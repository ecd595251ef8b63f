#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "planner/phase.hpp"

namespace kerf::planner {

/// Limits along the path, the first three > 0; an infinite jerk allows steps of the acceleration.
///
/// On a curve part of the axes' acceleration goes into its shape, the more the faster: what is left
/// for the speed is acceleration - fall v², not negative at `velocity`. With limited jerk `fall`
/// is 0.
struct PathLimits {
  double velocity = 0;
  double acceleration = 0;
  double jerk = std::numeric_limits<double>::infinity();
  double fall = 0;  ///< per mm, >= 0
};

/// A ramp changes the speed from one constant value to another as fast as acceleration, as it is at
/// the higher one, and jerk allow: with a finite jerk j its acceleration rises for T = a/j (or
/// √(Δv/j) when Δv < a²/j), stays, and falls for the same time. Time and length are the same in
/// both directions.
[[nodiscard]] double ramp_time_s(double from, double to, const PathLimits& limits);
[[nodiscard]] double ramp_length(double from, double to, const PathLimits& limits);

/// Highest speed that a ramp of `length` reaches from `from`; the velocity limit is not asked. At
/// least `from`.
[[nodiscard]] double reachable_speed(double from, double length, const PathLimits& limits);
/// The same, but no more than `most`.
[[nodiscard]] double reachable_speed(double from, double length, const PathLimits& limits,
                                     double most);

struct RampShape;

/// The fastest way over `length` >= 0 from speed `entry` to speed `exit`: a ramp up, a cruise, a
/// ramp down, each possibly of no duration; up to seven phases. It is as long as it should be, to
/// rounding. The acceleration is 0 at both ends when the jerk is limited. Value type, no
/// allocation.
class Profile {
 public:
  struct State {
    double position = 0;
    double velocity = 0;
    double acceleration = 0;  ///< right-hand limit where two phases meet
  };

  Profile() = default;
  /// A single phase.
  explicit Profile(const Phase& phase) : peak_(phase.velocity) { add(phase); }
  /// Precondition: both speeds within [0, limits.velocity], each reachable from the other over
  /// `length`, or nearly so by rounding.
  Profile(double length, double entry, double exit, const PathLimits& limits);

  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] double peak() const { return peak_; }
  [[nodiscard]] std::span<const Phase> phases() const { return {phases_.data(), count_}; }
  /// State at `t_s`, clamped to [0, duration_s()].
  [[nodiscard]] State state_at(double t_s) const;

 private:
  void add(const Phase& phase);
  void add_ramp(double from, double to, const RampShape& shape, double most_jerk, double share);

  std::array<Phase, 7> phases_;
  std::size_t count_ = 0;
  double duration_s_ = 0;
  double peak_ = 0;
};

}  // namespace kerf::planner
