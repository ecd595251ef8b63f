#include "machine/run/batch_run.hpp"

#include <algorithm>

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions between two looks at the clock: some milliseconds.
constexpr std::uint64_t kSlice = 200'000;

}  // namespace

// What the control asks

// A block may make any number of motions: between them the clock is looked at, too.
bool BatchRun::ready() const {
  if (!budget_.input_waits && input_wait().waits()) return false;
  return !motions_spent_ && !refused_ && !servo().broken_off() && !limit_.unwanted() &&
         statistics().motions() < slice_end_;
}

bool BatchRun::axes_have_arrived() {
  servo().finish();
  return true;
}

double BatchRun::seconds() {
  servo().finish();
  return servo().time_s();
}

bool BatchRun::all_motions_made() const {
  return budget_.motions != 0 && statistics().motions() >= budget_.motions;
}

// Beyond the budget nothing is handed out any more. What moves nothing may still follow its last
// motion: above all the end of the program.
bool BatchRun::admits(const motion::Motion& motion) {
  motions_spent_ |= all_motions_made() && motion::target_of(motion) != nullptr;
  if (motions_spent_ || refused_) return false;
  if (judge_ != nullptr) judge_->take(motion);
  return !refused_;
}

void BatchRun::refuse(const base::Diagnostic& alarm) {
  refused_ = true;
  servo().finish();
  if (!drive_alarm() && !servo().broken_off()) set_drive_alarm(alarm);
}

// Behind the budget or a refused motion, and where the axes stopped on their own, the control is
// some moves ahead of the machine.
base::MachinePoint BatchRun::position() const {
  if (servo().broken_off()) return machine_of(servo().last().tip, control().tool_length());
  if (!motions_spent_ && !refused_) return control().machine_position();
  return machine_of(statistics().at(), control().tool_length());
}

// The run

RunStatus BatchRun::cycle_start(const Budget& budget) { return go(budget, Stops::wait); }

RunStatus BatchRun::run_to_end(const Budget& budget) { return go(budget, Stops::pass); }

void BatchRun::reset() {
  reset_control();
  refused_ = false;
  notice_.reset();
}

RunStatus BatchRun::go(const Budget& budget, Stops stops) {
  budget_ = budget;
  watch_clock();
  if (status() == RunStatus::alarm) return status();
  if (!begin()) return finish(RunStatus::alarm);
  for (std::uint64_t steps = 0;;) {
    const std::uint64_t slice = budget.steps != 0 ? std::min(kSlice, budget.steps) : kSlice;
    const Halt halt = run_slice(slice);
    steps += slice;
    if (const auto end = over(halt, slice)) return *end;
    if (const auto end = halted(halt, stops)) return *end;
    if (budget.steps != 0 && steps >= budget.steps) return spent("the steps allowed are made");
    if (limit_.out_of_time()) return spent(limit_.reason());
  }
}

// One motion may have any number of set-points: between them the clock is looked at, too.
void BatchRun::watch_clock() {
  limit_ = base::WorkLimit(budget_.seconds, budget_.unwanted);
  servo().break_off_when([this] {
    if (progress_) progress_();
    return limit_.reached();
  });
}

bool BatchRun::begin() {
  const bool fresh = status() == RunStatus::idle || status() == RunStatus::end;
  if (status() == RunStatus::end) reset();
  return !fresh || start_program();
}

bool BatchRun::start_program() {
  set_alarm(named(language().start()));
  if (!alarm() || !search_) return !alarm();
  note_alarm(*alarm());
  return !language().start_all_the_same();
}

control::Halt BatchRun::run_slice(std::uint64_t steps) {
  slice_end_ = statistics().motions() + kSlice;
  if (budget_.motions != 0 && !all_motions_made())
    slice_end_ = std::min(slice_end_, budget_.motions);
  const Halt halt = control().run(steps);
  if (progress_) progress_();
  return halt;
}

// Whatever it has halted for: a program may do nothing but stop, and a batch run goes on.
std::optional<RunStatus> BatchRun::over(Halt halt, std::uint64_t steps) {
  if (halt == Halt::none && search_is_over(steps)) return finish(RunStatus::alarm);
  if (halt == Halt::none && (servo().broken_off() || refused_)) return finish(RunStatus::budget);
  if (!budget_.input_waits && input_wait().waits())
    return spent("it moves nothing, and only reads inputs", base::Code::waits_for_input);
  if (motions_spent_) return spent("the motions allowed are made");
  if (limit_.unwanted()) return spent(limit_.reason());
  return std::nullopt;
}

std::optional<RunStatus> BatchRun::halted(Halt halt, Stops stops) {
  switch (halt) {
    case Halt::end: return finish(RunStatus::end);
    case Halt::alarm:
      if (!passes_alarm()) return finish(RunStatus::alarm);
      break;
    case Halt::optional_stop: return finish(RunStatus::stopped);
    case Halt::single_block:
    case Halt::program_stop:
    case Halt::message:
    case Halt::gate:
      if (stops == Stops::wait) return finish(RunStatus::running);
      break;
    case Halt::none: break;
  }
  return std::nullopt;
}

// Its end

RunStatus BatchRun::finish(RunStatus status) {
  if (search_ && search_->any()) {
    status = end_search();
  } else {
    if (status == RunStatus::alarm && !alarm()) set_alarm(control().alarm());
    servo().finish();
    if (servo().broken_off() || refused_) status = broken_off(status);
  }
  set_status(status);
  return status;
}

// What the drives could not do comes before all that the control has met since.
RunStatus BatchRun::broken_off(RunStatus status) {
  if (drive_alarm()) {
    set_alarm(drive_alarm());
    return RunStatus::alarm;
  }
  note_spent(limit_.reason());
  return status == RunStatus::alarm ? status : RunStatus::budget;
}

void BatchRun::note_spent(const std::string& what, base::Code code) {
  notice_ = base::make_error(code, control().standing_at(), what);
  notice_->severity = base::Severity::warning;
  notice_->program = control().running_program();
}

RunStatus BatchRun::spent(const std::string& what, base::Code code) {
  note_spent(what, code);
  return finish(RunStatus::budget);
}

// Behind its alarms

void BatchRun::search_alarms() {
  search_.emplace();
  control().allow_passing();
}

// The axes come to rest, as they would where the control stops.
void BatchRun::note_alarm(const base::Diagnostic& alarm) {
  if (!search_->any()) {
    servo().finish();
    search_->stopped_at({made(), servo().time_s()});
    set_alarm(alarm);
    search_steps_ = 0;
  }
  search_->add(alarm);
}

bool BatchRun::passes_alarm() {
  if (!search_ || servo().broken_off()) return false;
  if (const auto& alarm = control().alarm()) note_alarm(*alarm);
  return !search_->is_cut_short() && control().pass_alarm();
}

// A halt has its reason, of which there are not so many; without one all steps were made.
bool BatchRun::search_is_over(std::uint64_t steps) {
  if (!search_ || !search_->any()) return false;
  search_steps_ += steps;
  if (search_steps_ < AlarmSearch::kMostSteps) return false;
  search_->cut_short();
  return true;
}

RunStatus BatchRun::end_search() {
  if (search_->is_cut_short()) note_spent("there is more behind its alarms, not looked at");
  servo().finish();
  return servo().broken_off() ? broken_off(RunStatus::alarm) : RunStatus::alarm;
}

}  // namespace kerf::machine
