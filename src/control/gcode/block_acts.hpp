#pragma once

#include <functional>

#include "control/gcode/acts/auxiliary.hpp"
#include "control/gcode/acts/data_setting.hpp"
#include "control/gcode/acts/drawing.hpp"
#include "control/gcode/acts/references.hpp"
#include "control/gcode/acts/settings.hpp"
#include "control/gcode/acts/surfaces.hpp"
#include "control/gcode/acts/tool_measurement.hpp"
#include "control/gcode/block_reader.hpp"
#include "control/gcode/cycles/canned_cycle.hpp"
#include "control/gcode/cycles/multiple_cycles.hpp"
#include "control/gcode/cycles/shape_cycles.hpp"
#include "control/gcode/cycles/single_cycles.hpp"
#include "control/gcode/cycles/turning_holes.hpp"
#include "control/gcode/path/block_buffer.hpp"

namespace kerf::control {

/// What one block does, in this order (docs/dialect/motion.md §8):
///   1. modal codes, F, S, T, D, H are taken over
///   2. S, T and the M codes that come before the motion act
///   3. the one-shot code or the motion of the block; of a cycle its holes or passes, one step() at
///      a time
///   4. the other M codes
/// Stops, ends, calls and returns are the control's.
class BlockActs {
 public:
  /// All must outlive this. `parameters_entered` is called behind each block that has entered some:
  /// whoever keeps of them ready looks anew.
  BlockActs(State& state, ProgramCalls& calls, BlockBuffer& buffer,
            std::function<void()> parameters_entered);

  /// A block begins: nothing of the one before it is left.
  void begin() {
    moved_ = false;
    codes_ = {};
    holes_.forget_clamp();
  }
  /// Steps 1 to 3. False: an alarm was raised.
  [[nodiscard]] bool execute(ReadBlock& block);
  /// Something is left of the block's cycle.
  [[nodiscard]] bool has_steps() const {
    return cycle_.running() || holes_.running() || turning_.running();
  }
  [[nodiscard]] bool step() {
    if (cycle_.running()) return cycle_.step();
    return holes_.running() ? holes_.step() : turning_.step();
  }
  void finish(const Words& words) { auxiliary_.after_motion(words, holes_.clamp()); }
  /// What is left of the block's cycle is not made.
  void stop() {
    cycle_.stop();
    holes_.stop();
    turning_.stop();
  }
  /// The data of a cycle are forgotten.
  void cancel_cycle() {
    cancel_holes();
    single_.forget();
  }

  /// The block has commanded axis movement.
  [[nodiscard]] bool moved() const { return moved_; }
  /// What its M codes ask of the control.
  [[nodiscard]] const Auxiliary::Codes& codes() const { return codes_; }
  /// The block goes on that had these.
  void take_up(const Auxiliary::Codes& codes) { codes_ = codes; }
  [[nodiscard]] const Targets& targets() const { return targets_; }
  /// Cycles that wait for a shape.
  [[nodiscard]] ShapeCycles& shapes() { return shapes_; }

 private:
  void cancel_holes() {
    cycle_.cancel();
    holes_.cancel();
  }
  [[nodiscard]] bool is_plain_move(const ReadBlock& block) const;
  [[nodiscard]] bool nose_may_have_changed() const;
  bool execute_in_full(ReadBlock& block);
  bool enter_parameter(const ReadBlock& block, const Words::G* one_shot);
  bool check_return(const Words& words);
  bool check_block(const Words& words, const Words::G* one_shot);
  bool end_modal_calls(const Words& words);
  bool tell_idle_words(const ReadBlock& block);
  bool check_look_ahead(const Words& words);
  bool move(ReadBlock& block, const Words::G* one_shot);
  bool select_cycle(Words& words, bool& plain);
  bool one_shot(const Words& words, const Words::G& g);
  bool dwell(const Words& words);

  State& state_;
  ProgramCalls& calls_;
  BlockBuffer& buffer_;
  std::function<void()> parameters_entered_;
  Targets targets_;
  Moves moves_;
  Drawing drawing_;
  Settings settings_;
  Surfaces surfaces_;
  DataSetting data_setting_;
  References references_;
  ToolMeasurement measurement_;
  Auxiliary auxiliary_;
  CannedCycle cycle_;
  TurningHoles holes_;
  TurningCycle turning_;
  SingleCycles single_;
  MultipleCycles multiple_;
  ShapeCycles shapes_;
  Auxiliary::Codes codes_;
  bool moved_ = false;
};

}  // namespace kerf::control
