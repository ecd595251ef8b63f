#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/work_limit.hpp"
#include "machine/run/alarm_search.hpp"
#include "machine/run/budget.hpp"
#include "machine/run/machine.hpp"

namespace kerf::machine {

/// A machine that goes on by itself, as fast as it is computed: whenever the control hands out more
/// than the servo has room for, points are made.
///
///   BatchRun run(definition, memory);
///   run.add_sink(sink);
///   run.load(file);
///   run.run_to_end(budget);
class BatchRun : public Machine {
 public:
  BatchRun(const MachineDefinition& definition, control::Memory memory)
      : BatchRun(definition, std::move(memory), Settings{}) {}
  BatchRun(const MachineDefinition& definition, control::Memory memory, const Settings& settings)
      : Machine(definition, std::move(memory), settings) {}

  /// For a check or a preview, never for a run that counts: run_to_end() goes on behind an alarm,
  /// without the block that raised it, as long as AlarmSearch allows. Status and alarm() are those
  /// of the first one. Precondition: nothing has run.
  void search_alarms();
  /// What was found so; null without search_alarms().
  [[nodiscard]] const AlarmSearch* alarm_search() const { return search_ ? &*search_ : nullptr; }
  /// Called every few milliseconds of computing while the machine runs.
  void observe_progress(std::function<void()> observer) { progress_ = std::move(observer); }
  /// Gets every motion before the machine makes it, and may refuse() it.
  void set_judge(motion::MotionSink& judge) { judge_ = &judge; }
  /// From within the judge: the motion is not made, nor any behind it. What was handed out before
  /// is made to its end, and the run ends in this alarm; that of a drive on the way comes first.
  void refuse(const base::Diagnostic& alarm);

  /// Starts the program, or goes on after a stop, until the next stop.
  RunStatus cycle_start(const Budget& budget = {});
  /// Goes on by itself after M00, #3006 and single block.
  RunStatus run_to_end(const Budget& budget = {});
  /// Modal state, modal calls, local and volatile variables go; position and offsets stay.
  void reset();

  /// Why and where a budget ended the run.
  [[nodiscard]] const std::optional<base::Diagnostic>& notice() const { return notice_; }
  /// Machine coordinates of all axes, tool length included: where the last motion ended that was
  /// within the budget; after an alarm of a drive, where the axes are.
  [[nodiscard]] base::MachinePoint position() const;

 private:
  enum class Stops : std::uint8_t { wait, pass };

  [[nodiscard]] bool ready() const override;
  [[nodiscard]] bool axes_have_arrived() override;
  [[nodiscard]] double seconds() override;
  [[nodiscard]] bool admits(const motion::Motion& motion) override;

  RunStatus go(const Budget& budget, Stops stops);
  [[nodiscard]] bool begin();
  [[nodiscard]] control::Halt run_slice(std::uint64_t steps);
  [[nodiscard]] std::optional<RunStatus> over(control::Halt halt, std::uint64_t steps);
  [[nodiscard]] std::optional<RunStatus> halted(control::Halt halt, Stops stops);
  [[nodiscard]] bool start_program();
  [[nodiscard]] bool all_motions_made() const;
  [[nodiscard]] bool passes_alarm();
  void note_alarm(const base::Diagnostic& alarm);
  [[nodiscard]] bool search_is_over(std::uint64_t steps);
  void watch_clock();
  void note_spent(const std::string& what, base::Code code = base::Code::budget_spent);
  RunStatus spent(const std::string& what, base::Code code = base::Code::budget_spent);
  RunStatus finish(RunStatus status);
  [[nodiscard]] RunStatus end_search();
  [[nodiscard]] RunStatus broken_off(RunStatus status);

  motion::MotionSink* judge_ = nullptr;
  std::function<void()> progress_;
  Budget budget_;
  base::WorkLimit limit_;
  std::uint64_t slice_end_ = 0;  // number of motions at which the clock is looked at
  bool motions_spent_ = false;   // one more than the budget has was asked for
  bool refused_ = false;         // by the judge
  std::optional<AlarmSearch> search_;
  std::uint64_t search_steps_ = 0;
  std::optional<base::Diagnostic> notice_;
};

}  // namespace kerf::machine
