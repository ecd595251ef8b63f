#pragma once

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/cycles/peck_passes.hpp"
#include "control/gcode/cycles/thread_passes.hpp"
#include "control/gcode/cycles/turning_cycle.hpp"

namespace kerf::control {

/// G74, G75 and G76: cycles that need no shape (docs/dialect/turning.md, pecks and threads). A
/// block without an end point sets parameters for those that follow.
class MultipleCycles {
 public:
  MultipleCycles(State& state, Targets& targets, Moves& moves, TurningCycle& turning)
      : state_(state), targets_(targets), moves_(moves), turning_(turning) {}

  /// A block with one of them. False: an alarm was raised.
  [[nodiscard]] bool execute(Meaning cycle, const Words& words, bool& moved);

 private:
  // G74 and G75.
  bool set_retreat(const Words& words);
  bool pecks(const Words& words, bool along_z);
  bool read_pecks(const Words& words, PeckPlan& plan);
  bool read_amount(const Words& words, char letter, char one_block, double& mm);

  // G76.
  bool set_thread(const Words& words);
  bool set_thread_code(const gcode::Word& word);
  bool set_tip_angle(std::int64_t degrees, const vm::Span& at);
  bool thread(const Words& words);
  bool read_depths(const Words& words, ThreadPlan& plan);
  bool read_height(const Words& words, double& mm);
  bool tell_infeed(const Words& words);

  bool read_end(const Words& words, const motion::PlaneAxes& axes, geometry::Vec2& end);
  bool in_increments(const gcode::Word& word, double& mm);

  State& state_;
  Targets& targets_;
  Moves& moves_;
  TurningCycle& turning_;
};

}  // namespace kerf::control
