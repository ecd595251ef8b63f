#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "machine/panel/internal/approach.hpp"
#include "machine/panel/internal/console.hpp"
#include "machine/panel/internal/entries.hpp"
#include "machine/panel/internal/hand_moves.hpp"
#include "machine/panel/internal/live_run.hpp"
#include "machine/panel/internal/live_view.hpp"
#include "machine/panel/internal/program_slot.hpp"
#include "machine/panel/internal/run_start.hpp"
#include "machine/panel/internal/start_rules.hpp"
#include "machine/panel/internal/switchboard.hpp"
#include "machine/panel/operation.hpp"

namespace kerf::machine {

/// The machine behind the panel: what the keys do, and what is to be seen. It joins the parts and
/// remembers nothing of what was (LiveMachine does).
///
/// Each program runs on a LiveRun made anew (begin_anew()). What an operator does takes effect
/// between two set-points; whatever follows depends on the number of points before it, and on no
/// clock.
class LiveCore {
 public:
  using Outcome = base::Outcome<void>;
  using Moment = PacedRun::Moment;
  static constexpr Moment kNever = PacedRun::kNever;

  explicit LiveCore(RunStart start);

  [[nodiscard]] RunStart run_start() const { return start_of(run_->machine()); }
  void add_sink(motion::MotionSink& sink);
  void add_point_sink(motion::AxisPointSink& sink);
  /// Where the axes stand.
  void tell_sinks() { machine().servo().tell_sinks(); }

  // Time

  void advance(double seconds);
  [[nodiscard]] Moment moment() const { return machine().moment(); }
  /// Up to a time of this run, and not beyond `last`.
  void advance_to(double until_s, const Moment& last);
  /// The last call has come to its time or moment: otherwise it had too much to compute.
  [[nodiscard]] bool is_reached() const { return reached_; }
  [[nodiscard]] std::uint64_t points() const { return machine().servo().points(); }
  [[nodiscard]] double time_s() const { return run_->time_s(); }
  /// Something moves or executes, or is held on the way.
  [[nodiscard]] bool is_active() const { return run_->is_active(); }
  /// How long what may take long goes on: a search for a line, points that are made at once.
  void set_limit(const base::WorkLimit& limit) { limit_ = limit; }
  [[nodiscard]] const base::WorkLimit& limit() const { return limit_; }

  // Keys

  /// Precondition: it is no StepBack, which is nothing that one machine does.
  Outcome perform(const Operation& key);
  /// Of a key that acts where the axes are (acts_on_axes()): what of it shows at once …
  void show(const Operation& key);
  /// … and what it does before its block.
  Outcome take_effect(const Operation& key);
  /// Has it take effect before the block of this number (Stepper::blocks()).
  void act_before(std::uint64_t block, const Operation& key);
  /// One of those could not be done.
  [[nodiscard]] bool has_refused() const { return has_refused_; }
  [[nodiscard]] Outcome can_load(const Load& key) const;

  // To see

  [[nodiscard]] Status status() const { return status_of(*run_, console_); }
  [[nodiscard]] Snapshot snapshot();
  [[nodiscard]] const LiveView& view() const { return view_; }
  [[nodiscard]] LiveRun& run() { return *run_; }
  [[nodiscard]] const LiveRun& run() const { return *run_; }
  [[nodiscard]] PacedRun& machine() { return run_->machine(); }
  [[nodiscard]] const PacedRun& machine() const { return std::as_const(*run_).machine(); }
  [[nodiscard]] Stepper& stepper() { return *stepper_; }
  [[nodiscard]] const PanelSettings& panel() const { return switchboard_.panel(); }
  [[nodiscard]] const Console& console() const { return console_; }
  [[nodiscard]] const ProgramSlot& slot() const { return slot_; }
  [[nodiscard]] const MachineDefinition& definition() const { return definition_; }
  [[nodiscard]] Standing standing() const {
    return {*run_, switchboard_.mode(), has_alarm(), slot_.text().has_value()};
  }
  /// The level of calls that an entry is for; where it names none, the innermost that is shown.
  [[nodiscard]] std::size_t shown_level(const SetVariable& key);
  /// How fast an axis is moved by hand where the key does not say it.
  [[nodiscard]] double own_speed(const JogBy& key) { return hand().own_speed(key.axis); }

  // In the place of another one

  /// Whether it stands where the other one does, with the same speed and acceleration.
  [[nodiscard]] bool moves_as(const LiveCore& other) const;
  /// Made again and at its end: blocks are counted no more.
  void stand_for_itself();
  /// Goes on in the place of a machine that stands at the same moment.
  void replace(const LiveCore& other);

 private:
  Outcome act(const Load& key);
  Outcome act(const SetMode& key) { return switchboard_.turn(key, *run_); }
  Outcome act(const CycleStart& key);
  Outcome act(const FeedHold& key);
  Outcome act(const Reset& key);
  Outcome act(const TurnSwitch& key);
  Outcome act(const SetBlockSkip& key);
  Outcome act(const Interrupt& key);
  Outcome act(const SetInput& key) { return Entries::enter(key, *run_); }
  Outcome act(const SetDials& key);
  template <typename Key>
  Outcome move_by_hand(const Key& key);
  Outcome act(const Jog& key) { return move_by_hand(key); }
  Outcome act(const JogBy& key) { return move_by_hand(key); }
  Outcome act(const JogStop& /*key*/) {
    hand().stop();
    return {};
  }
  Outcome act(const Home& key);
  Outcome act(const EnterBlocks& key);
  Outcome act(const EnterLine& key) {
    console_.enter(key.text);
    return {};
  }
  Outcome act(const TakeStep& key);
  Outcome act(const StepBack& key);
  Outcome act(const RunTo& key);
  Outcome act(const StartAt& key);
  Outcome act(const SetBreakpoints& key) { return stepper_->set_breakpoints(key.list); }
  Outcome act(const SetVariable& key);
  Outcome act(const SetOffset& key) { return enter(key); }
  Outcome act(const MeasureOffset& key) { return enter(key); }
  template <typename Key>
  Outcome enter(const Key& key) {
    auto set = Entries::enter(key, *run_);
    if (set) view_.note_change();
    return set;
  }
  Outcome act(const SetMemory& key) {
    set_memory(key.memory);
    return {};
  }
  Outcome act(const Raise& key) {
    machine().raise(key.alarm);
    return {};
  }
  Outcome take_effect_of(const SetVariable& key);

  [[nodiscard]] RunStart start_of(const PacedRun& machine) const;
  void begin_anew(MovedBy moved_by = MovedBy::hand) { begin_with(run_start(), moved_by); }
  void begin_with(RunStart start, MovedBy moved_by);
  void join(LiveRun& run);
  void set_memory(control::Memory memory);
  [[nodiscard]] bool has_alarm() const { return console_.alarm() || machine().alarm(); }
  [[nodiscard]] HandMoves hand() {
    return {*run_, console_, definition_, settings_, switchboard_.mode()};
  }
  void go_on();
  void end_unless(bool begun);
  void after_activity();
  void finish_reset();
  void finish_program();
  Outcome begin_program();
  Outcome begin_approach();
  Outcome set_off(bool may_step);
  [[nodiscard]] Outcome open_program() { return slot_.open(machine(), *stepper_); }

  MachineDefinition definition_;
  LiveMachine::Settings settings_;
  ProgramSlot slot_;
  Switchboard switchboard_;
  Console console_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<LiveRun> run_;
  Entries entries_;
  std::unique_ptr<Approach> approach_;  // null: nothing is to be approached
  LiveView view_;
  std::vector<motion::MotionSink*> sinks_;
  std::vector<motion::AxisPointSink*> point_sinks_;
  bool reached_ = false;
  bool has_refused_ = false;  // something that was to be done before a block
  base::WorkLimit limit_;
};

}  // namespace kerf::machine
