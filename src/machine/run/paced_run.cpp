#include "machine/run/paced_run.hpp"

#include <utility>

#include "machine/run/internal/pattern_return.hpp"

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions that the control makes between two looks at the servo, and how many such looks one
// call of advance() has for a program that commands nothing.
constexpr std::uint64_t kSliceOfPeriod = 100'000;
constexpr int kMostSlices = 4;

}  // namespace

PacedRun::PacedRun(const MachineDefinition& definition, control::Memory memory,
                   const Settings& settings)
    : Machine(definition, std::move(memory), settings) {
  servo().pace();
}

// What the control asks

bool PacedRun::ready() const {
  return diverted_ != nullptr || (servo().has_room() && !servo().broken_off());
}

bool PacedRun::axes_have_arrived() {
  if (diverted_ != nullptr || servo().at_rest()) return true;
  servo().finish();
  return false;
}

bool PacedRun::input_can_be_read() {
  waits_for_input_ = input_ready_ && !input_ready_();
  return !waits_for_input_;
}

bool PacedRun::admits(const motion::Motion& motion) {
  if (diverted_ == nullptr) return true;
  diverted_->take(motion);
  return false;
}

// Programs

bool PacedRun::begin(std::optional<base::Diagnostic> alarm) {
  set_alarm(named(std::move(alarm)));
  is_in_program_ = is_active_ = executes_ = !this->alarm();
  set_status(executes_ ? RunStatus::running : RunStatus::alarm);
  return executes_;
}

bool PacedRun::set_off() {
  if (!is_in_program_) return begin(language().start());
  is_active_ = executes_ = true;
  return true;
}

bool PacedRun::set_off_entry(std::unique_ptr<base::SourceFile> file) {
  return begin(language().start_entry(add_source(std::move(file))));
}

void PacedRun::drop_ahead() {
  servo().drop_waiting();
  is_active_ = is_by_hand_ = executes_ = waits_for_input_ = false;
  settle_by_hand();
  joints().stand_at(servo().joints());
}

// By hand

std::optional<control::Refusal> PacedRun::command(const motion::Motion& motion) {
  if (auto refused = refusal(servo().commanded(), motion, JointWatch::Intent::make)) return refused;
  switch_beam_off(motion);
  make(motion);
  is_active_ = is_by_hand_ = true;
  return std::nullopt;
}

bool PacedRun::command_way_to_start() {
  each_move_of_return(*PatternMachine::of(definition()), servo().joints(),
                      [this](const QueuedRecord& record, const motion::Motion& motion) {
                        records().push_back(record);
                        make(motion);
                        is_active_ = is_by_hand_ = true;
                      });
  servo().finish();
  return is_active_;
}

// To a line

void PacedRun::divert_motions(motion::MotionSink* sink) {
  diverted_ = sink;
  records().clear();
}

bool PacedRun::execute(std::uint64_t steps) { return control().run(steps) != Halt::none; }

void PacedRun::stand_by() {
  is_active_ = executes_ = false;
  joints().stand_at(servo().joints());
}

// Time

PacedRun::Moment PacedRun::moment() const {
  const std::uint64_t points = servo().points();
  if (servo().has_point()) return {points, Moment::kAllTurns};
  return {points, points == turns_at_ ? turns_ : 0};
}

void PacedRun::execute_ahead() {
  if (std::exchange(turns_at_, servo().points()) != servo().points()) turns_ = 0;
  ++turns_;
  const Halt halt = control().run(kSliceOfPeriod);
  executes_ = halt == Halt::none;
  if (!executes_ || waits_for_input_) servo().finish();
}

bool PacedRun::advance(double until_s, const Moment& last) {
  std::uint64_t points = servo().points();
  for (int slices = 0; is_active_;) {
    const Servo::Pace pace = servo().make_until(until_s, last.points);
    if (pace == Servo::Pace::reached) return true;
    if (std::exchange(points, servo().points()) != servo().points()) slices = 0;
    const bool rests = pace == Servo::Pace::at_rest;
    if (servo().broken_off() || servo().source().at_reset() || (rests && !executes_)) {
      settle();
    } else if (executes_) {
      if (slices++ == kMostSlices || moment() == last) return false;
      if (rests && waits_for_input_ && !input_ready_()) return false;
      waits_for_input_ = false;
      if (rests && at_rest_) at_rest_();
      execute_ahead();
    } else {
      servo().finish();
    }
  }
  return false;
}

// Everything is made: what the control has halted for is now.
void PacedRun::settle() {
  is_active_ = executes_ = waits_for_input_ = false;
  if (drive_alarm()) {
    set_alarm(drive_alarm());
    end_program(RunStatus::alarm);
  } else if (std::exchange(is_by_hand_, false) || !is_in_program_) {
    settle_by_hand();
  } else {
    settle_in_program();
  }
}

void PacedRun::settle_by_hand() {
  if (control().can_be_moved()) control().stand_at(servo().source().tip());
}

void PacedRun::end_program(RunStatus status) {
  is_in_program_ = false;
  set_status(status);
}

void PacedRun::settle_in_program() {
  switch (control().halt()) {
    case Halt::alarm:
      set_alarm(control().alarm());
      end_program(RunStatus::alarm);
      break;
    case Halt::end: end_program(RunStatus::end); break;
    case Halt::optional_stop: set_status(RunStatus::stopped); break;
    case Halt::none:
    case Halt::single_block:
    case Halt::program_stop:
    case Halt::message:
    case Halt::gate: set_status(RunStatus::running); break;
  }
}

}  // namespace kerf::machine
