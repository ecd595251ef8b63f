#pragma once

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// The spindles of a machine: which of them S, M03, M04, M05, M19 and the codes of its file mean
/// (docs/dialect/turning.md, "Spindles"). One is chosen, ModalWords::spindle: it has the last S,
/// and threads and taps are its. Starting a spindle chooses it.
class Spindles {
 public:
  explicit Spindles(State& state) : state_(state) {}

  /// Whether P of a block is the number of a spindle.
  [[nodiscard]] bool has_number(const Words& words) const;
  /// Chooses the spindle that the S of a block is for.
  void choose(const Words& words);
  /// Takes the S of a block over for the chosen spindle. False: an alarm was raised.
  [[nodiscard]] bool read_speed(const gcode::Word& word);
  /// What an M code of a spindle does.
  void act(const Words::M& code, const Words& words);
  /// The chosen one is recorded as it turns now.
  void tell();
  /// The zero of the work has moved under a constant surface speed: it is told again.
  void follow_work_zero();

 private:
  [[nodiscard]] motion::SpindleName named_by(const Words::M& code, const Words& words) const;
  [[nodiscard]] const SpindleSettings* numbered(const Words& words) const;
  void tell_number(const Words& words);
  void rest();

  State& state_;
  double told_centre_ = 0;  // of the spindle as it was told last
};

}  // namespace kerf::control
