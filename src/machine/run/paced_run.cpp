// A run by simulated time. The servo makes points up to a time; when it has made all that it can of
// what it has, the control executes blocks until the servo has no room for more. So both do the
// same things in the same order as in a batch run, however time is cut.
#include <utility>

#include "machine/run/internal/reach.hpp"
#include "machine/run/virtual_machine.hpp"

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions that the control makes between two looks at the servo, and how many such looks one
// call of advance() has for a program that commands nothing.
constexpr std::uint64_t kSlice = 100'000;
constexpr int kMostSlices = 4;

}  // namespace

void VirtualMachine::pace() {
  is_paced_ = true;
  servo_.pace();
  most_motions_ = 0;
}

bool VirtualMachine::begin_activity(std::optional<base::Diagnostic> alarm) {
  if (alarm && alarm->program.empty()) alarm->program = program_name();
  alarm_ = std::move(alarm);
  is_in_program_ = is_active_ = executes_ = !alarm_;
  status_ = alarm_ ? Status::alarm : Status::running;
  return !alarm_;
}

bool VirtualMachine::set_off() {
  if (!is_in_program_) return begin_activity(dialect_->start());
  is_active_ = executes_ = true;
  return true;
}

bool VirtualMachine::set_off_entry(std::unique_ptr<base::SourceFile> file) {
  return begin_activity(dialect_->start_entry(sources_.add(std::move(file))));
}

std::optional<control::Refusal> VirtualMachine::command(const motion::Motion& motion) {
  if (auto refused = refusal(servo_.commanded(), motion, Intent::make)) return refused;
  if (made_beam_.beam_percent() > 0) switch_beam({}, motion);
  make(motion);
  is_active_ = is_by_hand_ = true;
  return std::nullopt;
}

void VirtualMachine::finish_moves() { servo_.finish(); }

VirtualMachine::Moment VirtualMachine::moment() const {
  const std::uint64_t points = servo_.points();
  if (servo_.has_point()) return {points, Moment::kAllTurns};
  return {points, points == turns_at_ ? turns_ : 0};
}

void VirtualMachine::execute_ahead() {
  if (std::exchange(turns_at_, servo_.points()) != servo_.points()) turns_ = 0;
  ++turns_;
  const Halt halt = control().run(kSlice);
  executes_ = halt == Halt::none;
  if (!executes_ || waits_for_input_) servo_.finish();
}

void VirtualMachine::stand_by() {
  is_active_ = executes_ = false;
  if (reach_) reach_->set_joints(servo_.joints());
}

bool VirtualMachine::execute(std::uint64_t steps) { return control().run(steps) != Halt::none; }

bool VirtualMachine::advance(double until_s, const Moment& last) {
  std::uint64_t points = servo_.points();
  for (int slices = 0; is_active_;) {
    const Servo::Pace pace = servo_.make_until(until_s, last.points);
    if (pace == Servo::Pace::reached) return true;
    if (std::exchange(points, servo_.points()) != servo_.points()) slices = 0;
    const bool rests = pace == Servo::Pace::at_rest;
    if (servo_.broken_off() || servo_.source().at_reset() || (rests && !executes_)) {
      settle();
    } else if (executes_) {
      if (slices++ == kMostSlices || moment() == last) return false;
      if (rests && waits_for_input_ && !input_ready_()) return false;
      waits_for_input_ = false;
      if (rests && at_rest_) at_rest_();
      execute_ahead();
    } else {
      servo_.finish();
    }
  }
  return false;
}

// Everything is made: what the control has halted for is now.
void VirtualMachine::settle() {
  is_active_ = executes_ = waits_for_input_ = false;
  if (drive_alarm_) {
    alarm_ = drive_alarm_;
    is_in_program_ = false;
    status_ = Status::alarm;
    return;
  }
  if (std::exchange(is_by_hand_, false) || !is_in_program_) {
    if (control().can_be_moved()) control().stand_at(servo_.source().tip());
    return;
  }
  switch (control().halt()) {
    case Halt::alarm:
      alarm_ = control().alarm();
      is_in_program_ = false;
      status_ = Status::alarm;
      break;
    case Halt::end:
      is_in_program_ = false;
      status_ = Status::end;
      break;
    case Halt::optional_stop: status_ = Status::stopped; break;
    case Halt::none:
    case Halt::single_block:
    case Halt::program_stop:
    case Halt::message:
    case Halt::gate: status_ = Status::running; break;
  }
}

void VirtualMachine::drop_ahead() {
  servo_.drop_waiting();
  is_active_ = is_by_hand_ = executes_ = waits_for_input_ = false;
  if (control().can_be_moved()) control().stand_at(servo_.source().tip());
  if (reach_) reach_->set_joints(servo_.joints());
}

}  // namespace kerf::machine
