#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "machine/dialect/variable_listing.hpp"
#include "machine/panel/internal/block_trail.hpp"
#include "machine/panel/internal/console.hpp"
#include "machine/panel/internal/line_finder.hpp"
#include "machine/panel/panel.hpp"
#include "machine/run/latest_points.hpp"
#include "machine/run/paced_run.hpp"
#include "machine/run/read_ahead.hpp"

namespace kerf::machine {

/// What is under way.
enum class Activity : std::uint8_t { none, program, jog, home, approach };
/// Whose moves a run was made for.
enum class MovedBy : std::uint8_t { hand, program };

/// The end of a jog, or of other moves by hand, that is not the operator's.
struct HandEnd {
  base::Code code{};
  std::string sentence;
};

/// What is made anew for each program: the machine, what it has done and read that the axes have
/// not come to, what is under way, and what holds it.
class LiveRun : private motion::AxisPointSink {
 public:
  /// The stepper must outlive it; `number` counts runs.
  LiveRun(const MachineDefinition& definition, control::Memory memory,
          const Machine::Settings& settings, Stepper& stepper, MovedBy moved_by,
          std::uint64_t number);

  [[nodiscard]] PacedRun& machine() { return machine_; }
  [[nodiscard]] const PacedRun& machine() const { return machine_; }
  [[nodiscard]] BlockTrail& trail() { return trail_; }
  [[nodiscard]] LineFinder& lines() { return lines_; }
  [[nodiscard]] planner::SetpointSource& source() { return machine_.servo().source(); }
  [[nodiscard]] const motion::Setpoint& last() const { return machine_.servo().last(); }
  [[nodiscard]] double time_s() const { return last().time_s; }
  [[nodiscard]] bool is_active() const { return machine_.is_active(); }
  /// A drive has stopped the axes.
  [[nodiscard]] bool is_broken_off() const { return machine_.servo().broken_off(); }
  [[nodiscard]] base::JointPoint standing_joints() const {
    return machine_.servo().stands_at().joints;
  }
  [[nodiscard]] const LatestPoints& latest() const { return latest_; }
  /// It runs the records of a pattern, which count pulses.
  [[nodiscard]] bool is_pattern() const;
  /// The motors that count a pattern are not needed any more.
  [[nodiscard]] bool is_behind_pattern() const;

  // What is under way

  /// Points of this run are wanted from now on.
  void begin(Activity activity);
  /// Likewise; it counts as another run.
  void begin_next(Activity activity);
  /// The moves of an operator, one behind the other. Failure: the joints cannot follow the first
  /// one, and nothing is under way; of a later one they end before it.
  [[nodiscard]] base::Outcome<void> move_by_hand(const std::vector<motion::Motion>& motions);
  [[nodiscard]] bool is(Activity activity) const { return activity_ == activity; }
  /// Of what has come to its end.
  [[nodiscard]] Activity end_activity() { return std::exchange(activity_, Activity::none); }
  [[nodiscard]] std::uint64_t number() const { return number_; }
  void set_number(std::uint64_t number) { number_ = number; }

  /// Whether the moves of an operator have come to an end that is not his, which is an alarm.
  [[nodiscard]] bool ended_early(Console& console);
  /// Behind a reset, at rest: nothing is under way, the program is over.
  void finish_reset();
  // What nobody has been told yet.
  void tell_messages(Console& console);
  void tell_missed_interrupts(Console& console);

  // What holds it

  void hold_feed();
  /// Behind the block that is being made.
  void hold_behind_block();
  [[nodiscard]] bool is_feed_held() const { return feed_hold_; }
  [[nodiscard]] bool is_held_behind_block() const { return block_hold_; }
  /// By the operator or a switch: cycle start goes on.
  [[nodiscard]] bool is_held() const { return feed_hold_ || block_hold_; }
  void resume_feed();
  /// Everything before the hold behind a block is made, and the program is over: nothing to hold.
  [[nodiscard]] bool outruns_block_hold();
  void release_holds() { feed_hold_ = block_hold_ = false; }
  /// A dial at 0 holds the motions that it is for; the others go on.
  void set_dials(const OverrideDials& dials);

  // What was read, and the axes

  [[nodiscard]] ReadAhead::Place begun() { return read_ahead_.at(last().mark.motion); }
  [[nodiscard]] ReadAhead::Place read() { return read_ahead_.newest(); }
  /// Blocks of a program were executed whose motions are not made.
  [[nodiscard]] bool is_ahead() const;
  /// Nothing moves: held, in a dwell, or waiting.
  [[nodiscard]] bool stands() const;
  /// What the control showed with the motion that is being made; null: none is.
  [[nodiscard]] const BlockState* block_made();
  /// Likewise; null: everything is made, and the control's own is what counts.
  [[nodiscard]] const BlockState* image_made();
  /// Calls that are open, as they are shown.
  [[nodiscard]] std::size_t shown_levels();

  // Its memory. The control is ahead of the axes, and what a reset or a loss of power keeps is what
  // they have come to.

  [[nodiscard]] control::Memory memory();
  void set_memory(control::Memory memory);
  /// The axes have stopped on their way.
  void forget_ahead();
  /// A listing reads names and system variables from the memory itself: that of the block that is
  /// made.
  [[nodiscard]] VariableListing at_block_made(const std::function<VariableListing()>& list);

  double deadline_s = 0;  ///< of the run: up to when points are wanted
  bool is_entry = false;  ///< what runs, or has run, is an entry in MDI
  bool is_resetting = false;
  bool was_stepping = false;        ///< the last cycle start was a step
  bool is_jog_stopping = false;     ///< the operator ends it
  std::optional<HandEnd> hand_end;  ///< told when the moves have come to it

 private:
  // AxisPointSink: looks at every point.
  void take(const motion::AxisPoint& point) override;
  void put_back(const BlockState& made, control::Memory& memory) const;
  void release_dial();

  PacedRun machine_;
  BlockTrail trail_;
  ReadAhead read_ahead_;
  LatestPoints latest_;
  LineFinder lines_;
  MovedBy moved_by_;
  Activity activity_ = Activity::none;
  OverrideDials dials_;
  bool feed_hold_ = false;   // pressed
  bool block_hold_ = false;  // the feed holds behind the block: single block
  bool dial_hold_ = false;   // a dial stands at 0
  std::uint64_t number_;
  std::size_t said_ = 0;  // of the program's own messages
  std::uint64_t interrupts_missed_ = 0;
};

}  // namespace kerf::machine
