#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/findings.hpp"
#include "base/source_file.hpp"
#include "base/work_limit.hpp"
#include "control/core/control.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/signals.hpp"
#include "machine/run/alarm_search.hpp"
#include "machine/run/dotted_cut.hpp"
#include "machine/run/input_wait.hpp"
#include "machine/run/run_statistics.hpp"
#include "machine/run/servo.hpp"
#include "machine/run/spindle_beam.hpp"

namespace kerf::machine {

class Reach;

/// Where the skip signal of a probing move comes on: the machine position of an axis.
struct SkipContact {
  base::Axis axis{};
  double machine = 0;
};

/// Limits of a run; 0: none.
struct Budget {
  double seconds = 60;  ///< of computing
  std::uint64_t motions = 50'000'000;
  std::uint64_t steps = 0;     ///< jumps, blocks and pages, about
  bool input_waits = true;     ///< false: a program that waits for an input (InputWait) ends there
  std::stop_token unwanted{};  ///< stopped: the run ends in Status::budget within milliseconds
};

/// A machine with its control and the switches of its panel. A batch run and a live panel are the
/// same thing; the one goes on by itself where the other waits for cycle start.
///
/// Owns everything that the machine needs; two machines never meet. Not thread-safe.
class VirtualMachine : private control::Surroundings, private motion::MotionSink {
 public:
  enum class Status : std::uint8_t {
    idle,     ///< nothing has run since power-on or reset
    running,  ///< waits for cycle start in the middle of a program: single block, M00, #3006
    stopped,  ///< M01 with the switch on
    end,      ///< M02 or M30
    alarm,
    budget  ///< a limit was reached
  };

  struct Settings {
    vm::PageSettings pages;
    std::string dialect;   ///< check_dialect() has nothing against it; empty: the machine's own
    bool by_hand = false;  ///< what the operator commands moves the axes, and no program
  };

  VirtualMachine(const MachineDefinition& definition, control::Memory memory)
      : VirtualMachine(definition, std::move(memory), Settings{}) {}
  VirtualMachine(const MachineDefinition& definition, control::Memory memory,
                 const Settings& settings);
  ~VirtualMachine() override;

  // Preparation

  /// The file whose first program is to run. Alarms in its structure (PS0073, PS0074) are raised at
  /// cycle start.
  void load(std::unique_ptr<base::SourceFile> file);
  void add_library_folder(const std::string& folder) { dialect_->add_library_folder(folder); }
  /// For a check or a preview, never for a run that counts: run_to_end() goes on behind an alarm,
  /// without the block that raised it, as long as AlarmSearch allows. Status and alarm() are those
  /// of the first one. Precondition: nothing has run.
  void search_alarms();
  /// What was found so; null without search_alarms().
  [[nodiscard]] const AlarmSearch* alarm_search() const { return search_ ? &*search_ : nullptr; }
  /// Called every few milliseconds of computing while the machine runs.
  void observe_progress(std::function<void()> observer) { progress_ = std::move(observer); }
  void add_sink(motion::MotionSink& sink) { sinks_.push_back(&sink); }
  /// Set-points at every period of the servo; making them takes time.
  void add_point_sink(motion::AxisPointSink& sink) { servo_.add_sink(sink); }
  /// For whoever takes set-points and cannot follow them, as the alarm of a drive: the point under
  /// way is the last one, and the run ends in this alarm. The control, which is ahead of the axes,
  /// may have gone on by some blocks. Of several alarms the first one counts.
  void raise(const base::Diagnostic& alarm);
  /// Gets every motion before the machine makes it, and may refuse() it.
  void set_judge(motion::MotionSink& judge) { judge_ = &judge; }
  /// From within the judge: the motion is not made, nor any behind it. What was handed out before
  /// is made to its end, and the run ends in this alarm; that of a drive on the way comes first.
  void refuse(const base::Diagnostic& alarm);
  void set_print_output(std::function<void(std::string_view)> output) {
    print_output_ = std::move(output);
  }
  /// Where INPUT reads its lines: the next one without its end, or nothing when there is none.
  /// Without it there are none.
  void set_input(std::function<std::optional<std::string>()> input) { input_ = std::move(input); }
  void add_skip_contact(const SkipContact& contact) { contacts_.push_back(contact); }
  /// A variable by its name in the program's language ("#100"). Before the start local ones are
  /// those of the main program. Failure (usage).
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) {
    return dialect_->variables().set(name, value);
  }

  // The panel

  void set_single_block(bool on) { dialect_->control().set_single_block(on); }
  void set_optional_stop(bool on) { dialect_->control().set_optional_stop(on); }
  /// One bit per level: bit n for /n, n = 1 to 9.
  void set_block_skip(std::uint32_t levels) { dialect_->control().set_block_skip(levels); }

  /// Starts the program, or goes on after a stop, until the next stop.
  Status cycle_start(const Budget& budget = {});
  /// Goes on by itself after M00, #3006 and single block.
  Status run_to_end(const Budget& budget = {});
  /// Modal state, modal calls, local and volatile variables go; position and offsets stay.
  void reset();
  /// The signal of a macro interrupt (M96).
  void interrupt() { dialect_->control().interrupt(); }
  // By simulated time (LiveMachine). Set-points and blocks are the same as without.

  /// From now on time passes by advance(); cycle_start() and run_to_end() are not for this machine.
  /// Precondition: nothing has run.
  void pace();
  /// Begins the program, or goes on behind a stop, as advance() has it. False: an alarm.
  bool set_off();
  /// Begins an entry in MDI. False: an alarm.
  bool set_off_entry(std::unique_ptr<base::SourceFile> file);
  /// A move that the operator commands, from where the axes rest, without the beam of a laser;
  /// finish_moves() behind the last one. Otherwise why the joints cannot follow it; then nothing
  /// has changed.
  [[nodiscard]] std::optional<control::Refusal> command(const motion::Motion& motion);
  void finish_moves();
  /// Brings the motors back to where every counter is 0, clear of the work; false: they are there.
  /// Precondition: the machine makes patterns, and the axes rest.
  bool command_way_to_start();
  /// How far a run has come, which does not depend on how time is cut.
  struct Moment {
    static constexpr std::uint64_t kAllTurns = ~std::uint64_t{0};
    std::uint64_t points = 0;  ///< that were handed out
    /// That the control had since the last of them; kAllTurns: the next point is made and waits.
    std::uint64_t turns = 0;
    bool operator==(const Moment&) const = default;
  };
  static constexpr Moment kNever{~std::uint64_t{0}, Moment::kAllTurns};
  [[nodiscard]] Moment moment() const;
  /// Makes set-points up to a time of the run, and executes blocks as far as the servo has room for
  /// what they command; not beyond `last`. True: the time is reached. False: the axes rest and
  /// nothing follows (!is_active()), or there was too much to compute for one call, or a line of
  /// input is missing.
  bool advance(double until_s, const Moment& last);
  /// Blocks or points are to come.
  [[nodiscard]] bool is_active() const { return is_active_; }
  /// The program has begun and is not over.
  [[nodiscard]] bool is_in_program() const { return is_in_program_; }
  [[nodiscard]] bool waits_for_input() const { return waits_for_input_; }
  /// Whether the line that INPUT waits for is there; without it all of them are.
  void set_input_ready(std::function<bool()> question) { input_ready_ = std::move(question); }
  /// Behind servo().source().reset(), at rest: forgets what was ahead. The control stands where the
  /// axes do; program and alarm are as they were.
  void drop_ahead();
  [[nodiscard]] Servo& servo() { return servo_; }
  [[nodiscard]] const Servo& servo() const { return servo_; }
  [[nodiscard]] Dialect& language() { return *dialect_; }
  [[nodiscard]] const Dialect& language() const { return *dialect_; }
  /// Called before the control executes blocks while all that it has commanded is made.
  void observe_rest(std::function<void()> observer) { at_rest_ = std::move(observer); }
  [[nodiscard]] const Signals& signals() const { return signals_; }
  void set_signals(const Signals& signals) { signals_ = signals; }
  /// What is done with motions on their way to the servo; the sinks get them as they were.
  void alter_motions(std::function<motion::Motion(const motion::Motion&)> change) {
    alter_ = std::move(change);
  }
  /// While on, motions go to `sink` and to nobody else: the control comes to a line without moving
  /// anything. Null: off.
  void divert_motions(motion::MotionSink* sink) {
    diverted_ = sink;
    records_.clear();
  }
  /// The program that was begun will not go on.
  void abandon() { is_in_program_ = false; }
  /// Behind a diverted run: the program waits where it has halted. Joints are where they stand.
  void stand_by();
  /// The control has halted, whatever is still to be made.
  [[nodiscard]] bool has_halted() const { return !executes_; }
  /// Why the joints could not follow a move from where the axes rest.
  [[nodiscard]] std::optional<control::Refusal> objection(const motion::Motion& motion) {
    return refusal(servo_.commanded(), motion, Intent::ask);
  }
  /// Of a diverted run: at most so many steps. False: it has not halted.
  bool execute(std::uint64_t steps);

  /// Called at the beginning of every block; slows the machine down.
  void observe_blocks(control::Control::BlockObserver observer) {
    dialect_->control().observe_blocks(std::move(observer));
  }

  // What there is to see

  [[nodiscard]] Status status() const { return status_; }
  [[nodiscard]] control::Halt halt() const { return dialect_->control().halt(); }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const { return alarm_; }
  /// What is made and is probably a mistake: of a laser the first cut whose pulses do not join and
  /// the first S above full power, of a linkage the first cut near a singular position.
  [[nodiscard]] std::vector<base::Diagnostic> warnings() const;
  /// Why and where a budget ended the run.
  [[nodiscard]] const std::optional<base::Diagnostic>& notice() const { return notice_; }
  [[nodiscard]] const MachineDefinition& definition() const { return definition_; }
  [[nodiscard]] const RunStatistics& statistics() const { return statistics_; }
  /// The program has read an input signal: what it does may depend on it.
  [[nodiscard]] bool has_read_inputs() const { return input_wait_.any(); }
  /// Time that the axes took so far, dwells included.
  [[nodiscard]] double time_s() const { return servo_.time_s(); }
  [[nodiscard]] const std::string& dialect() const { return dialect_name_; }
  [[nodiscard]] control::Control& control() { return dialect_->control(); }
  [[nodiscard]] const control::Control& control() const { return dialect_->control(); }
  [[nodiscard]] control::Memory& memory() { return memory_; }
  [[nodiscard]] const control::Memory& memory() const { return memory_; }
  /// Machine coordinates of all axes, tool length included: where the last motion ended that was
  /// within the budget; after an alarm of a drive, where the axes are.
  [[nodiscard]] base::AxisVector position() const;
  [[nodiscard]] const base::SourceSet& sources() const { return sources_; }
  /// Name of the loaded program: "O0001", "<NAME>" without its brackets, "O0000" without a number.
  [[nodiscard]] std::string program_name() const { return dialect_->program_name(); }
  /// The program's variables that are not null, in the order of its language.
  [[nodiscard]] std::vector<Variable> variables() { return dialect_->variables().all(); }
  /// Mistakes of the loaded programs that show without running them. A check whose limit is reached
  /// ends in the warning BUDGET.
  void check(base::Findings& found);
  [[nodiscard]] std::vector<base::Diagnostic> check();

 private:
  // control::Surroundings
  bool axes_have_arrived() override;
  double seconds() override;
  double date() override { return signals_.date(seconds()); }
  double time_of_day() override { return signals_.time_of_day(seconds()); }
  std::optional<control::Refusal> refusal(const base::AxisVector& from, const motion::Motion& move,
                                          Intent intent) override;
  std::optional<double> contact(const base::AxisVector& from, const base::AxisVector& to) override;
  std::uint32_t inputs(std::size_t word) override;
  void print(std::string_view text) override;
  bool input_can_be_read() override;
  std::optional<std::string> input() override { return input_ ? input_() : std::nullopt; }

  // control::MotionSink
  void take(const motion::Motion& motion) override;
  void make(const motion::Motion& motion);
  void look_for_caution(const motion::Motion& move);
  void switch_beam(const motion::Power& power, const motion::Motion& move);
  bool ready() const override;
  [[nodiscard]] bool all_motions_made() const;

  bool begin_activity(std::optional<base::Diagnostic> alarm);
  void execute_ahead();
  void settle();
  bool start_program();
  Status go(const Budget& budget, bool batch);
  Status finish(Status status);
  Status spent(const std::string& what);
  Status waits_for_signal();
  bool passes_alarm();
  void note_alarm(const base::Diagnostic& alarm);
  [[nodiscard]] bool search_is_over(std::uint64_t steps);
  Status end_search();
  void note_spent(const std::string& what, base::Code code = base::Code::budget_spent);
  Status broken_off(Status status);
  void watch_clock(const base::WorkLimit& limit);
  [[nodiscard]] static std::string words_for(const base::WorkLimit& limit);

  MachineDefinition definition_;
  control::Memory memory_;
  base::SourceSet sources_;
  Signals signals_;
  RunStatistics statistics_;
  SpindleBeam spindle_beam_;
  motion::Power beam_;       // as the program has it
  motion::Power made_beam_;  // as the machine has it
  DottedCut dotted_cut_;
  std::string dialect_name_;
  PatternQueue records_;  // of a pattern, between control and servo
  Servo servo_;
  std::unique_ptr<Reach> reach_;  // null: the driven axes are the program's
  std::optional<base::Diagnostic> near_singular_;
  motion::MotionSink* judge_ = nullptr;
  std::vector<motion::MotionSink*> sinks_;
  std::function<void(std::string_view)> print_output_;
  std::function<std::optional<std::string>()> input_;
  std::function<void()> progress_;
  std::deque<SkipContact> contacts_;
  std::unique_ptr<Dialect> dialect_;
  std::optional<base::Diagnostic> alarm_;
  std::optional<base::Diagnostic> drive_alarm_;
  std::optional<base::Diagnostic> notice_;
  Status status_ = Status::idle;
  base::WorkLimit limit_;
  std::uint64_t most_motions_ = 0;
  std::uint64_t slice_end_ = 0;   // number of motions at which the clock is looked at
  bool motions_spent_ = false;    // one more than most_motions_ was asked for
  bool refused_ = false;          // by the judge
  std::uint64_t handed_out_ = 0;  // motions, moves or not
  InputWait input_wait_;
  bool input_waits_ = true;  // as the budget has it
  std::optional<AlarmSearch> search_;
  std::uint64_t search_steps_ = 0;

  // Paced.
  bool is_paced_ = false;
  bool is_active_ = false;
  bool is_in_program_ = false;
  bool executes_ = false;    // the control has not halted
  std::uint64_t turns_ = 0;  // of the control, behind so many points:
  std::uint64_t turns_at_ = 0;
  bool is_by_hand_ = false;  // what moves was commanded by the operator
  bool waits_for_input_ = false;
  std::function<bool()> input_ready_;
  std::function<void()> at_rest_;
  std::function<motion::Motion(const motion::Motion&)> alter_;
  motion::MotionSink* diverted_ = nullptr;
};

}  // namespace kerf::machine
