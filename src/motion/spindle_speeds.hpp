#pragma once

#include <array>
#include <optional>

#include "motion/axis_setup.hpp"
#include "motion/spindle_set.hpp"

namespace kerf::motion {

/// A spindle goes to another speed.
struct SpindleTurn {
  double rpm = 0;           ///< < 0: it depends on the tip's place, or it turns the other way
  double acceleration = 0;  ///< rpm/s by which it goes there; 0: at once, in either direction
  SpindleName spindle = SpindleName::main;
};

/// The spindles beside a path: says how their speeds change, and for which a cut must wait, because
/// a change takes time (AxisSetup). At constant surface speed a rapid changes it to that of its
/// end, and a cut takes it along at once.
class SpindleSpeeds {
 public:
  /// Must outlive this.
  explicit SpindleSpeeds(const AxisSetup& axes) : axes_(axes), spindles_(axes.standing_rpm) {}

  /// What feeds per revolution and threads follow.
  [[nodiscard]] const Spindle& of_feed() const { return spindles_.of_feed(); }
  /// What the operator makes of speeds, > 0.
  [[nodiscard]] double override_factor() const { return override_; }
  void set_override(double factor) { override_ = factor; }

  // What comes next on the path, and what that makes of the speed.
  SpindleTurn command(const Spindle& spindle, const base::TipPoint& tip);
  [[nodiscard]] std::optional<SpindleTurn> go_fast_to(const base::TipPoint& tip);
  void cut_to(const base::TipPoint& tip);

  /// A spindle that a cut must wait for, and the most that this may last.
  struct Arrival {
    SpindleName spindle{};
    double most_s = 0;
  };
  /// The next one, which is then no longer waited for.
  [[nodiscard]] std::optional<Arrival> next_arrival();

 private:
  struct Speed {
    double rpm = 0;        // that it goes to; negative: the other way round
    double arrival_s = 0;  // most that this may last; 0: nothing waits for it
  };
  SpindleTurn change(const Spindle& spindle, const base::TipPoint& tip);
  [[nodiscard]] double acceleration_of(const Spindle& spindle) const {
    return axes_.spindle_acceleration[index(spindle.name)];
  }
  [[nodiscard]] double signed_rpm(const Spindle& spindle, const base::TipPoint& tip) const;

  const AxisSetup& axes_;
  SpindleSet spindles_;
  double override_ = 1;
  std::array<Speed, kSpindles> speeds_{};
};

}  // namespace kerf::motion
