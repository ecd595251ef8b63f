#pragma once

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// The end point that the axis words of a block ask for.
struct Target {
  base::ProgramPoint program;
  base::AxisSet named = 0;  ///< axes that have a word
};

/// Reads axis words: absolute or incremental (G90, G91, or by their letter), cartesian or polar
/// (G15, G16), diameters halved.
class Targets {
 public:
  explicit Targets(State& state) : state_(state) {}

  /// The target of a move from the programmed point. False: an alarm was raised.
  [[nodiscard]] bool read(const Words& words, Target& target);
  /// These axes are to move. False: one of them cannot, the spindle may be none now (PS0197).
  [[nodiscard]] bool command(base::AxisSet named);
  /// The values of all axis words of a block as written; `values` keeps what no word names, and is
  /// what a word counts from that is incremental by its letter.
  [[nodiscard]] bool values(const Words& words, base::AxisVector& values, base::AxisSet& named);
  /// Value of one axis word, mm or degrees.
  [[nodiscard]] bool value(const gcode::Word& word, base::Axis axis, double& value);
  /// Says once that the number of a word counts least increments, if it has no decimal point.
  void tell_increments(const gcode::Word& word, bool angle);
  /// The word of an axis, null: it has none. Of two the last one counts.
  [[nodiscard]] const gcode::Word* word_of(const Words& words, base::Axis axis) const;
  /// Whether a word is a way along its axis because of its letter: U of a lathe.
  [[nodiscard]] bool is_way(const gcode::Word& word, base::Axis axis) const {
    return word.letter != state_.axes[axis].letter;
  }
  /// Axes whose word is a way by its letter.
  [[nodiscard]] base::AxisSet ways(const Words& words) const;
  /// Mask of the machine's axis letters.
  [[nodiscard]] std::uint32_t letters() const { return letters_; }
  void learn_letters();

  void begin_polar() { radius_ = angle_deg_ = 0; }

 private:
  bool read_polar(const Words& words, Target& target);
  [[nodiscard]] bool ways_have_letters() const {
    return state_.codes.habits().letters_are_increments;
  }

  State& state_;
  std::uint32_t letters_ = 0;
  double radius_ = 0;  // of the last polar point
  double angle_deg_ = 0;
};

}  // namespace kerf::control
