#pragma once

#include <array>

#include "motion/motion.hpp"

namespace kerf::motion {

/// The spindles of a machine as they were commanded last, and the one that feeds per revolution and
/// threads follow: the driven tool's while that turns; else of those that turn the one commanded
/// last; while none turns the one commanded last.
class SpindleSet {
 public:
  /// A spindle without a speed counts as having `standing_rpm`.
  explicit SpindleSet(double standing_rpm = 0) : standing_rpm_(standing_rpm) {
    for (std::size_t i = 0; i < kSpindles; ++i) {
      spindles_[i].name = static_cast<SpindleName>(i);
      spindles_[i].speed = standing_rpm;
    }
  }

  void take(Spindle spindle) {
    if (spindle.speed == 0 && spindle.mode == Spindle::Mode::rpm) spindle.speed = standing_rpm_;
    spindles_[index(spindle.name)] = spindle;
    of_feed_ = chosen_behind(spindle);
  }
  [[nodiscard]] const Spindle& of_feed() const { return spindles_[index(of_feed_)]; }

 private:
  [[nodiscard]] bool turns(SpindleName name) const { return spindles_[index(name)].turns(); }
  [[nodiscard]] SpindleName chosen_behind(const Spindle& last) const {
    if (turns(SpindleName::live)) return SpindleName::live;
    if (last.turns()) return last.name;
    if (turns(of_feed_)) return of_feed_;
    for (const SpindleName name : {SpindleName::main, SpindleName::sub}) {
      if (turns(name)) return name;
    }
    return last.name;
  }

  std::array<Spindle, kSpindles> spindles_;
  SpindleName of_feed_ = SpindleName::main;
  double standing_rpm_;
};

}  // namespace kerf::motion
