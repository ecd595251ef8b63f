#pragma once

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// One-shot codes that move: G27 to G30 (reference points), G31 (skip), G45 to G48 (offset moves),
/// G53 (machine coordinates), G60 (docs/dialect.md §8.3, §8.6).
class References {
 public:
  References(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// Executes a code. `moved`: axis movement was commanded. False: an alarm was raised.
  [[nodiscard]] bool execute(const Words::G& g, const Words& words, bool& moved);

 private:
  bool return_to_reference(const Words& words, std::size_t point, bool& moved);
  bool return_to_further_reference(const Words& words, bool& moved);
  bool return_from_reference(const Words& words, bool& moved);
  bool check_reference(const Words& words, bool& moved);
  bool machine_position(const Words& words, bool& moved);
  bool skip(const Words& words, bool& moved);
  bool offset_move(int times, const Words& words, bool& moved);
  /// Fast move of some axes to machine coordinates, without tool length and cutter compensation.
  bool rapid_to_machine(const base::MachinePoint& machine, base::AxisSet named);

  State& state_;
  Targets& targets_;
  Moves& moves_;
};

}  // namespace kerf::control
