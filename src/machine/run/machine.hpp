#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/findings.hpp"
#include "base/source_file.hpp"
#include "control/core/control.hpp"
#include "control/core/memory.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/signals.hpp"
#include "machine/run/dotted_cut.hpp"
#include "machine/run/input_wait.hpp"
#include "machine/run/joint_watch.hpp"
#include "machine/run/run_statistics.hpp"
#include "machine/run/run_status.hpp"
#include "machine/run/servo.hpp"
#include "machine/run/skip_contacts.hpp"
#include "machine/run/spindle_beam.hpp"
#include "machine/run/turning_statistics.hpp"
#include "motion/skip_signal.hpp"

namespace kerf::machine {

/// A machine with its control: the program in, motions and set-points out. When the control
/// executes blocks and when the axes move is up to the run, which is one of two: BatchRun goes to
/// the end by itself, PacedRun by simulated time.
///
/// Owns everything that the machine needs; two machines never meet. Not thread-safe: all sinks,
/// observers and questions are called on the thread that runs it.
class Machine : private control::Surroundings, private motion::MotionSink {
 public:
  /// What stands before a program is loaded. Value type.
  struct Settings {
    std::string dialect{};  ///< check_dialect() has nothing against it; empty: the machine's own
    std::vector<std::string> library_folders{};  ///< of programs that can be called
    Signals signals{};
    std::uint32_t block_skip = 0;  ///< one bit per level: bit n for /n, n = 1 to 9
    bool optional_stop = false;
    bool by_hand = false;  ///< what the operator commands moves the axes, and no program
    vm::PageSettings pages{};
    /// Motions that were planned, in place of a program; null: there are none.
    std::shared_ptr<const control::MotionMaker> plan{};
    bool on_one_thread = false;  ///< the planner, too (Servo): the same, and to compare
  };

  ~Machine() override;

  // Preparation

  /// The file whose first program is to run. Alarms in its structure (PS0073, PS0074) are raised
  /// when it starts.
  void load(std::unique_ptr<base::SourceFile> file);
  void add_sink(motion::MotionSink& sink) { sinks_.push_back(&sink); }
  /// Set-points at every period of the servo; making them takes time.
  void add_point_sink(motion::AxisPointSink& sink) { servo_.add_sink(sink); }
  /// Is told when motions end, perhaps on another thread. Precondition: nothing has run.
  void tell_ends(motion::MotionEndSink& sink) { servo_.tell_ends(sink); }
  void set_print_output(std::function<void(std::string_view)> output) {
    print_output_ = std::move(output);
  }
  /// Where INPUT reads its lines: the next one without its end, or nothing when there is none.
  /// Without it there are none.
  void set_input(std::function<std::optional<std::string>()> input) { input_ = std::move(input); }
  void add_skip_contact(const SkipContact& contact) { contacts_.add(contact); }
  /// Where the skip signals of probes come from while nobody has added a contact. It outlives the
  /// machine; without one none comes.
  void set_skip_signal(motion::SkipSignal& signal) { skip_signal_ = &signal; }
  /// A variable by its name in the program's language ("#100"). Before the start local ones are
  /// those of the main program. Failure (usage).
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) {
    return dialect_->variables().set(name, value);
  }
  /// Called at the beginning of every block; slows the machine down.
  void observe_blocks(control::Control::BlockObserver observer) {
    dialect_->control().observe_blocks(std::move(observer));
  }
  /// Mistakes of the loaded programs that show without running them. A check whose limit is reached
  /// ends in the warning BUDGET.
  void check(base::Findings& found);
  [[nodiscard]] std::vector<base::Diagnostic> check();

  // On the way

  /// For whoever takes set-points and cannot follow them, as the alarm of a drive: the point under
  /// way is the last one, and the run ends in this alarm. The control, which is ahead of the axes,
  /// may have gone on by some blocks. Of several alarms the first one counts.
  void raise(const base::Diagnostic& alarm);

  // What there is to see

  [[nodiscard]] RunStatus status() const { return status_; }
  [[nodiscard]] control::Halt halt() const { return control().halt(); }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const { return alarm_; }
  /// What is made and is probably a mistake: of a laser the first cut whose pulses do not join and
  /// the first S above full power, of a linkage the first cut near a singular position.
  [[nodiscard]] std::vector<base::Diagnostic> warnings() const;
  [[nodiscard]] const MachineDefinition& definition() const { return definition_; }
  [[nodiscard]] const RunStatistics& statistics() const { return statistics_; }
  [[nodiscard]] const TurningStatistics& turning_statistics() const { return turning_statistics_; }
  /// The program has read an input signal: what it does may depend on it.
  [[nodiscard]] bool has_read_inputs() const { return input_wait_.any(); }
  /// Time that the axes took so far, dwells included.
  [[nodiscard]] double time_s() const { return servo_.time_s(); }
  [[nodiscard]] const std::string& dialect() const { return dialect_name_; }
  [[nodiscard]] Dialect& language() { return *dialect_; }
  [[nodiscard]] const Dialect& language() const { return *dialect_; }
  [[nodiscard]] control::Control& control() { return dialect_->control(); }
  [[nodiscard]] const control::Control& control() const { return dialect_->control(); }
  [[nodiscard]] control::Memory& memory() { return memory_; }
  [[nodiscard]] const control::Memory& memory() const { return memory_; }
  [[nodiscard]] Servo& servo() { return servo_; }
  [[nodiscard]] const Servo& servo() const { return servo_; }
  [[nodiscard]] const Signals& signals() const { return signals_; }
  [[nodiscard]] const base::SourceSet& sources() const { return sources_; }
  /// Name of the loaded program: "O0001", "<NAME>" without its brackets, "O0000" without a number.
  [[nodiscard]] std::string program_name() const { return dialect_->program_name(); }
  /// The program's variables that are not null, in the order of its language.
  [[nodiscard]] std::vector<Variable> variables() { return dialect_->variables().all(); }

 protected:
  Machine(const MachineDefinition& definition, control::Memory memory, const Settings& settings);

  // What a run decides.

  /// Whether the control may go on handing out motions.
  [[nodiscard]] bool ready() const override = 0;
  [[nodiscard]] bool axes_have_arrived() override = 0;
  [[nodiscard]] double seconds() override = 0;
  [[nodiscard]] bool input_can_be_read() override { return true; }
  /// False: this motion is not made, nor seen by anybody.
  [[nodiscard]] virtual bool admits(const motion::Motion& motion) = 0;

  // What a run works with.

  [[nodiscard]] std::optional<control::Refusal> refusal(const base::TipPoint& from,
                                                        const motion::Motion& move,
                                                        Intent intent) override {
    return joints_.refusal(from, move, intent);
  }
  void make(const motion::Motion& motion);
  /// What is done with motions on their way to the servo; the sinks get them as they were.
  void alter_motions(std::function<motion::Motion(const motion::Motion&)> change) {
    alter_ = std::move(change);
  }
  /// The move is made with the beam off, whatever the program has; its next one finds it as it was.
  void switch_beam_off(const motion::Motion& move);
  [[nodiscard]] base::FileId add_source(std::unique_ptr<base::SourceFile> file) {
    return sources_.add(std::move(file));
  }
  /// Modal state, modal calls, local and volatile variables go; position and offsets stay.
  void reset_control();
  /// Of the program at its start: it has its name.
  [[nodiscard]] std::optional<base::Diagnostic> named(std::optional<base::Diagnostic> alarm) const;
  void set_status(RunStatus status) { status_ = status; }
  void set_alarm(std::optional<base::Diagnostic> alarm) { alarm_ = std::move(alarm); }
  [[nodiscard]] const std::optional<base::Diagnostic>& drive_alarm() const { return drive_alarm_; }
  void set_drive_alarm(const base::Diagnostic& alarm) { drive_alarm_ = alarm; }
  [[nodiscard]] JointWatch& joints() { return joints_; }
  [[nodiscard]] PatternQueue& records() { return records_; }
  [[nodiscard]] const InputWait& input_wait() const { return input_wait_; }
  /// Motions that were made, moves or not.
  [[nodiscard]] std::uint64_t made() const { return made_; }

 private:
  // control::Surroundings
  double date() override { return signals_.date(seconds()); }
  double time_of_day() override { return signals_.time_of_day(seconds()); }
  std::optional<double> contact(const motion::SkipMove& move) override;
  std::uint32_t inputs(std::size_t word) override;
  void print(std::string_view text) override;
  std::optional<std::string> input() override { return input_ ? input_() : std::nullopt; }

  // motion::MotionSink
  void take(const motion::Motion& motion) override;
  [[nodiscard]] std::optional<motion::Motion> z_first(const motion::Motion& motion) const;
  void switch_beam(const motion::Power& power, const motion::Motion& move);

  MachineDefinition definition_;
  control::Memory memory_;
  base::SourceSet sources_;
  Signals signals_;
  RunStatistics statistics_;
  TurningStatistics turning_statistics_;
  SpindleBeam spindle_beam_;
  motion::Power beam_;       // as the program has it
  motion::Power made_beam_;  // as the machine has it
  DottedCut dotted_cut_;
  std::string dialect_name_;
  PatternQueue records_;  // of a pattern, between control and servo
  Servo servo_;
  JointWatch joints_;
  std::vector<motion::MotionSink*> sinks_;
  std::function<motion::Motion(const motion::Motion&)> alter_;
  std::function<void(std::string_view)> print_output_;
  std::function<std::optional<std::string>()> input_;
  SkipContacts contacts_;
  motion::SkipSignal* skip_signal_ = nullptr;
  InputWait input_wait_;
  std::unique_ptr<Dialect> dialect_;
  RunStatus status_ = RunStatus::idle;
  std::optional<base::Diagnostic> alarm_;
  std::optional<base::Diagnostic> drive_alarm_;
  std::uint64_t made_ = 0;
};

}  // namespace kerf::machine
