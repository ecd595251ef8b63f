#pragma once

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// The end point that the axis words of a block ask for.
struct Target {
  base::ProgramPoint program;
  base::AxisSet named = 0;  ///< axes that have a word
};

/// Reads axis words: absolute or incremental (G90, G91), cartesian or polar (G15, G16).
class Targets {
 public:
  explicit Targets(State& state) : state_(state) {}

  /// The target of a move from the programmed point. False: an alarm was raised.
  [[nodiscard]] bool read(const Words& words, Target& target);
  /// The values of all axis words of a block as written; `values` keeps what no word names.
  [[nodiscard]] bool values(const Words& words, base::AxisVector& values, base::AxisSet& named);
  /// Value of one axis word, mm or degrees.
  [[nodiscard]] bool value(const gcode::Word& word, base::Axis axis, double& value);
  /// Mask of the machine's axis letters.
  [[nodiscard]] std::uint32_t letters() const { return letters_; }
  void learn_letters();

  void begin_polar() { radius_ = angle_deg_ = 0; }

 private:
  bool read_polar(const Words& words, Target& target);

  State& state_;
  std::uint32_t letters_ = 0;
  double radius_ = 0;  // of the last polar point
  double angle_deg_ = 0;
};

}  // namespace kerf::control
