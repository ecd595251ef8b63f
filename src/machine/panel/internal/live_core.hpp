#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machine/panel/internal/block_trail.hpp"
#include "machine/panel/internal/line_finder.hpp"
#include "machine/panel/live_machine.hpp"
#include "machine/run/latest_points.hpp"
#include "machine/run/paced_run.hpp"
#include "machine/run/read_ahead.hpp"

namespace kerf::machine {

/// All that a run begins with: made from it again, a machine does the same again.
struct RunStart {
  MachineDefinition definition;  ///< its start is where the axes stand
  control::Memory memory;
  LiveMachine::Settings settings;
  std::string dialect;
  PanelSettings panel{};
  std::optional<base::ProgramText> program{};
  std::vector<Breakpoint> breakpoints{};
  base::AxisVector shift{};  ///< of G92
  Signals signals{};
  std::string printed{};  ///< the end of it
  std::uint64_t printed_bytes = 0;
};

/// The machine behind the panel: what the keys do, and what is to be seen. It remembers nothing of
/// what was (LiveMachine does).
///
/// Each program runs on a PacedRun made anew (begin_anew()). What an operator does takes
/// effect between two set-points; whatever follows depends on the number of points before it, and
/// on no clock.
class LiveCore : private motion::AxisPointSink {
 public:
  using Outcome = base::Outcome<void>;

  explicit LiveCore(RunStart start);
  ~LiveCore() override;

  [[nodiscard]] RunStart run_start() const;
  void add_sink(motion::MotionSink& sink);
  void add_point_sink(motion::AxisPointSink& sink);
  void raise(const base::Diagnostic& alarm);
  /// Where the axes stand.
  void tell_sinks();

  // Time
  void advance(double seconds);
  using Moment = PacedRun::Moment;
  static constexpr Moment kNever = PacedRun::kNever;
  [[nodiscard]] Moment moment() const { return machine_->moment(); }
  /// Up to a time of this run, and not beyond `last`.
  void advance_to(double until_s, const Moment& last);
  /// Stands where the other one does, with the same speed and acceleration.
  [[nodiscard]] bool moves_as(const LiveCore& other) const;
  /// How long what may take long goes on: a search for a line, points that are made at once.
  void set_limit(const base::WorkLimit& limit) { limit_ = limit; }
  [[nodiscard]] const base::WorkLimit& limit() const { return limit_; }
  /// The last call has come to its time or moment: otherwise it had too much to compute.
  [[nodiscard]] bool is_reached() const { return reached_; }
  [[nodiscard]] std::uint64_t points() const { return machine_->servo().points(); }
  [[nodiscard]] double time_s() const { return machine_->servo().last().time_s; }
  /// Something moves or executes, or is held on the way.
  [[nodiscard]] bool is_active() const { return machine_->is_active(); }
  /// A drive has stopped the axes: reset makes the machine anew.
  [[nodiscard]] bool is_broken_off() const { return machine_->servo().broken_off(); }

  // The panel, as in LiveMachine
  [[nodiscard]] Outcome can_load(const base::ProgramText& program,
                                 const std::string& dialect) const;
  Outcome load(base::ProgramText program, std::string dialect);
  Outcome set_mode(Mode mode);
  /// Whether cycle start begins the program, on a machine made anew.
  [[nodiscard]] bool would_begin() const;
  /// Whether axes moved by hand are moved on a machine made anew: behind a pattern.
  [[nodiscard]] bool would_begin_by_hand() const;
  Outcome cycle_start();
  Outcome feed_hold();
  void reset();
  Outcome set_switch(Switch which, bool on);
  Outcome set_block_skip(std::uint32_t levels);
  // What it does, one by one.
  [[nodiscard]] static Outcome check_skip_levels(std::uint32_t levels);
  Outcome show_block_skip(std::uint32_t levels);
  Outcome apply_block_skip(std::uint32_t levels);
  Outcome interrupt();
  Outcome set_input(const std::string& name, double value);
  Outcome set_dials(const OverrideDials& dials);
  Outcome jog(const std::string& axis, double speed_per_min);
  Outcome jog_by(const std::string& axis, double distance, double speed_per_min);
  Outcome jog_stop();
  Outcome home();
  Outcome mdi(const std::string& text);
  Outcome enter(std::string line);
  Outcome step(Step how);
  Outcome run_to(const std::string& file, std::uint32_t line);
  Outcome start_at(std::uint32_t line);
  Outcome set_breakpoints(std::vector<Breakpoint> breakpoints);
  Outcome set_variable(const std::string& name, std::optional<double> value,
                       std::optional<std::size_t> level);
  /// Whatever moves: before a block that the axes have not begun.
  Outcome enter_variable(const std::string& name, std::optional<double> value,
                         std::optional<std::size_t> level);
  /// What was entered so counts for the blocks before that, too: the panel shows it, and a reset
  /// keeps it.
  Outcome show_variable(const std::string& name, std::optional<double> value,
                        std::optional<std::size_t> level);
  Outcome set_offset(const std::string& offset, const std::string& axis, double value);
  /// Precondition: nothing moves.
  void set_memory(control::Memory memory);

  // To see
  /// That of the block that is made: what a reset or a loss of power keeps.
  [[nodiscard]] control::Memory memory();
  [[nodiscard]] Status status() const;
  [[nodiscard]] Snapshot snapshot();
  [[nodiscard]] VariableListing variables(std::optional<std::size_t> level);
  [[nodiscard]] VariableListing variables_named(const std::vector<std::string>& names,
                                                std::optional<std::size_t> level);
  [[nodiscard]] const PanelSettings& panel() const { return panel_; }
  [[nodiscard]] const std::optional<base::ProgramText>& program() const { return program_; }
  [[nodiscard]] const std::string& dialect() const { return dialect_; }
  [[nodiscard]] Stepper& stepper() { return *stepper_; }
  [[nodiscard]] PacedRun& machine() { return *machine_; }
  [[nodiscard]] const PacedRun& machine() const { return *machine_; }
  [[nodiscard]] const MachineDefinition& definition() const { return definition_; }
  [[nodiscard]] std::uint64_t run() const { return run_; }
  void set_run(std::uint64_t run) { run_ = run; }
  [[nodiscard]] base::JointPoint standing_joints() const;

  // What the program has read that the axes have not begun
  [[nodiscard]] ReadAhead::Place begun() {
    return read_ahead_->at(machine_->servo().last().mark.motion);
  }
  [[nodiscard]] ReadAhead::Place read() { return read_ahead_->newest(); }
  /// Blocks of a program were executed whose motions are not made.
  [[nodiscard]] bool is_ahead() const;
  /// Nothing moves: held, in a dwell, or waiting.
  [[nodiscard]] bool stands() const;
  /// The innermost level of the calls that is shown.
  [[nodiscard]] std::size_t shown_level();
  /// Does something before the block of this number (Stepper::blocks()).
  void act_before(std::uint64_t block, const std::function<Outcome(LiveCore&)>& act);
  /// One of those could not be done.
  [[nodiscard]] bool has_refused() const { return has_refused_; }
  /// Goes on in the place of a machine that stands at the same moment.
  void replace(const LiveCore& other);

 private:
  /// What is under way.
  enum class Activity : std::uint8_t { none, program, jog, home, approach };
  /// The end of a jog, or of other moves by hand, that is not the operator's.
  struct JogEnd {
    base::Code code{};
    std::string sentence;
  };
  /// What a program restarted in its middle needs before its first move.
  struct Approach;
  using Values = std::map<std::pair<std::string, std::size_t>, double>;

  // AxisPointSink: looks at every point.
  void take(const motion::AxisPoint& point) override;

  [[nodiscard]] std::string language_of(const std::string& dialect) const;
  enum class MovedBy : std::uint8_t { hand, program };
  void begin_anew(MovedBy moved_by = MovedBy::hand);
  [[nodiscard]] bool is_pattern() const;
  void tell_pattern_times();
  [[nodiscard]] base::Outcome<void> open_program();
  void apply_panel();
  void apply_switches();
  void apply_dials();
  [[nodiscard]] motion::Motion altered(const motion::Motion& motion) const;
  void go_on();
  void resume_feed();
  void after_activity();
  void finish_reset();
  void finish_program();
  Outcome begin_program();
  Outcome set_off(bool may_step);
  [[nodiscard]] std::optional<base::Failure> keeps_from_start() const;
  [[nodiscard]] std::optional<base::Failure> keeps_from_hand() const;
  [[nodiscard]] std::optional<base::Axis> find_axis(const std::string& name) const;
  [[nodiscard]] bool ended_early();
  void take_in_hand();
  Outcome home_motors();
  Outcome jog_to(base::Axis axis, double distance, double speed_per_min);
  [[nodiscard]] double travel_left(base::Axis axis, bool up) const;
  [[nodiscard]] double reachable(const motion::Motion& whole, base::Axis axis, double distance,
                                 std::optional<JogEnd>& end);
  void raise_panel(base::Code code, const std::string& sentence);
  [[nodiscard]] Outcome queue_moves(const std::vector<motion::Motion>& motions);
  Outcome begin_approach();
  void show_place(Snapshot& shown);
  void show_functions(Snapshot& shown);
  void show_positions(Snapshot& shown);
  void show_alarm(Snapshot& shown) const;
  void show_stack(Snapshot& shown);
  [[nodiscard]] Values values();
  [[nodiscard]] const BlockState* block_made();
  [[nodiscard]] const BlockState* image_made();
  void put_back(const BlockState& made, control::Memory& memory) const;
  void forget_ahead();
  [[nodiscard]] VariableListing at_block_made(const std::function<VariableListing()>& list);
  [[nodiscard]] VariableListing list_variables(std::optional<std::size_t> level);
  [[nodiscard]] VariableListing list_named(const std::vector<std::string>& names,
                                           std::optional<std::size_t> level);
  void say(std::string message);
  void tell_missed_interrupts();

  MachineDefinition definition_;
  LiveMachine::Settings settings_;
  std::string dialect_;
  PanelSettings panel_;
  std::optional<base::ProgramText> program_;
  std::unique_ptr<PacedRun> machine_;
  std::unique_ptr<BlockTrail> trail_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<ReadAhead> read_ahead_;
  std::vector<motion::MotionSink*> sinks_;
  std::vector<motion::AxisPointSink*> point_sinks_;

  Activity activity_ = Activity::none;
  MovedBy moved_by_ = MovedBy::hand;
  bool is_entry_ = false;    // what runs, or has run, is an entry in MDI
  bool feed_hold_ = false;   // pressed
  bool block_hold_ = false;  // the feed holds behind the block: single block
  bool dial_hold_ = false;   // a dial stands at 0
  bool resetting_ = false;
  bool stopping_jog_ = false;
  bool was_stepping_ = false;
  std::optional<JogEnd> jog_end_;
  std::unique_ptr<Approach> approach_;
  std::optional<base::Diagnostic> panel_alarm_;
  bool reached_ = false;
  base::WorkLimit limit_;
  double deadline_s_ = 0;  // of the run: up to when points are wanted
  std::uint64_t run_ = 0;
  std::uint64_t changes_ = 0;  // of variables, by the operator
  std::deque<std::string> messages_;
  std::size_t said_ = 0;  // of the program's own
  std::uint64_t interrupts_missed_ = 0;
  std::string printed_;
  std::uint64_t printed_bytes_ = 0;
  std::deque<std::string> input_;
  std::map<std::string, std::uint64_t> entered_;  // the first motion that knows of the entry
  LatestPoints latest_;
  bool has_refused_ = false;  // something that was to be done before a block
  LineFinder lines_;
  Values before_;  // at the last stop but one
  Values at_stop_;
};

}  // namespace kerf::machine
