#pragma once

#include <array>
#include <optional>
#include <span>

#include "base/diagnostic.hpp"
#include "machine/definition/drive_settings.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// What a program's spindle means on a machine that has a laser instead (docs/drives.md, M03, M04
/// and S): M03 is the beam with constant power, M04 with power that follows the speed, M05 no
/// beam. S is the power, of LaserSettings::s_of_full_power; more than that is full power and a
/// warning.
///
/// The beam is on from the first cut behind M03 or M04, a G01 without a way among them; in rapids,
/// probing moves, stops and behind the end it is off. A dwell has what was before it.
class SpindleBeam {
 public:
  explicit SpindleBeam(const LaserSettings& laser) : laser_(laser) {}

  /// What the machine does for a motion of the control, in order; valid until the next call. Of the
  /// spindle that is nothing, or a Power where the beam changes. On a machine without a laser it is
  /// the motion. A Power whose pulses are as frequent as the machine's says no frequency.
  [[nodiscard]] std::span<const motion::Motion> translated(const motion::Motion& motion);
  /// The spindle stands.
  void reset();
  // At the line of the motion, which is all that their places say.
  /// OVER_FULL_POWER.
  [[nodiscard]] const std::optional<base::Diagnostic>& warning() const { return warning_; }
  /// BEAM_OFF_IN_DWELL: the first dwell that burns nothing although M03 or M04 is active.
  [[nodiscard]] const std::optional<base::Diagnostic>& dwell_warning() const {
    return dwell_warning_;
  }

 private:
  [[nodiscard]] motion::Power as_of_machine(motion::Power power) const;
  void turn(const motion::Motion& motion, const motion::Spindle& spindle);
  void light(const motion::Motion& motion, bool on);
  void rest(const motion::Motion& motion);
  [[nodiscard]] double percent_of(const motion::Motion& motion, double s);
  void put(const motion::Motion& motion, const motion::Motion::Action& action);

  LaserSettings laser_;
  motion::Power power_;  // while it turns
  bool turns_ = false;
  bool lit_ = false;
  std::array<motion::Motion, 2> motions_;
  std::size_t count_ = 0;
  std::optional<base::Diagnostic> warning_;
  std::optional<base::Diagnostic> dwell_warning_;
};

}  // namespace kerf::machine
