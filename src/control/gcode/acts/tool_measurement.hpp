#pragma once

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// G36 X and G37 Z of a lathe: the tool goes to a sensor whose place is known, and what the place
/// of the signal differs from it is added to the wear of the offset in force
/// (docs/dialect/turning.md, "Measuring tools").
///
///   rapid to γ before the place ·· at the measuring feed to the signal, at most to ε behind it
class ToolMeasurement {
 public:
  ToolMeasurement(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// A block with G36 (`letter` X) or G37 (Z). False: an alarm was raised, PS0080 to PS0083.
  [[nodiscard]] bool execute(char letter, const Words& words, bool& moved);

 private:
  bool check(const Words& words, const base::Axis& axis);
  bool approach(base::Axis axis, double place);
  bool touch(base::Axis axis, double place);
  void correct(base::Axis axis, double difference);
  [[nodiscard]] bool is_x(base::Axis axis) const { return state_.axes[axis].letter == 'X'; }

  State& state_;
  Targets& targets_;
  Moves& moves_;
  double side_ = 1;  // of the sensor, seen from the tool
};

}  // namespace kerf::control
