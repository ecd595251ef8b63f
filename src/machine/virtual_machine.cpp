#include "machine/virtual_machine.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/decimal.hpp"
#include "kinematics/fault.hpp"
#include "lang/vm/value.hpp"
#include "machine/internal/reach.hpp"

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions between two looks at the clock: some milliseconds.
constexpr std::uint64_t kSlice = 200'000;
constexpr double kSecondsPerDay = 86400;

tl::unexpected<base::Failure> unusable(std::uint32_t number, const std::string& why) {
  return tl::unexpected(
      base::Failure{base::Failure::Kind::usage, "#" + std::to_string(number) + ": " + why});
}

}  // namespace

VirtualMachine::VirtualMachine(const MachineDefinition& definition, control::Memory memory,
                               const Settings& settings)
    : definition_(definition),
      memory_(std::move(memory)),
      library_(sources_, settings.library),
      shelf_(sources_, library_),
      statistics_(definition_.axes),
      servo_(definition_) {
  if (definition_.axes.linked)
    reach_ = std::make_unique<Reach>(servo_.kinematics(), definition_.axes, definition_.start);
  first_locals_.fill(vm::kNull);
  power_on();
}

VirtualMachine::~VirtualMachine() = default;

void VirtualMachine::power_on() {
  control::Surroundings& surroundings = *this;
  control::MotionSink& sink = *this;
  controller_ = std::make_unique<control::Controller>(
      definition_.parameters, definition_.axes, memory_, library_, shelf_, surroundings, sink);
}

void VirtualMachine::load(std::unique_ptr<base::SourceFile> file) {
  const std::string name = file->name();
  if (name != "-") {
    shelf_.know(name);
    shelf_.add_folder(std::filesystem::path(name).parent_path().string());
  }
  main_file_ = sources_.add(std::move(file));
  library_.add_file(main_file_);
}

std::string VirtualMachine::program_name() const {
  if (library_.program_count() == 0) return "O0000";
  return gcode::name_of(library_.entry(vm::CodeId{0}));
}

void VirtualMachine::raise(const base::Diagnostic& alarm) {
  if (!drive_alarm_) drive_alarm_ = alarm;
  servo_.break_off();
}

// Behind the budget, and where the axes stopped on their own, the control is some moves ahead of
// the machine.
base::AxisVector VirtualMachine::position() const {
  if (servo_.broken_off()) return servo_.last().tip + controller_->coordinates().length();
  if (!motions_spent_) return controller_->machine_position();
  return statistics_.at() + controller_->coordinates().length();
}

base::Outcome<void> VirtualMachine::set_variable(std::uint32_t number, double value) {
  if (number >= 1000 && number <= 1035) return set_input(number, value);
  if (number == 3011) return set_date(value);
  if (number == 3012) return set_time(value);
  if (status_ == Status::idle && number > 0 && number < gcode::kLocals) {
    first_locals_[number] = value;
    return {};
  }
  return controller_->set_variable(number, value);
}

// #1000 to #1015 are bits, #1032 is all of them, #1033 to #1035 are words of 32 bits.
base::Outcome<void> VirtualMachine::set_input(std::uint32_t number, double value) {
  if (number > 1015 && number < 1032) return unusable(number, "there is no such input");
  if (number < 1016) {
    const std::uint32_t bit = 1U << (number - 1000);
    inputs_[0] = value != 0 ? inputs_[0] | bit : inputs_[0] & ~bit;
    return {};
  }
  const double rounded = std::round(value);
  if (rounded < -2147483648.0 || rounded > 4294967295.0)
    return unusable(number, "32 bits do not hold this value");
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded));
  inputs_[number - 1032] = number == 1032 ? bits & 0xffffU : bits;
  return {};
}

base::Outcome<void> VirtualMachine::set_date(double value) {
  constexpr double kMostDate = 99991231;
  const auto date = static_cast<int>(std::clamp(value, 0.0, kMostDate));
  const std::chrono::year_month_day day{std::chrono::year{date / 10000},
                                        std::chrono::month{static_cast<unsigned>(date / 100 % 100)},
                                        std::chrono::day{static_cast<unsigned>(date % 100)}};
  if (!day.ok() || date != value) return unusable(3011, "a date is written yyyymmdd");
  start_day_ = day;
  return {};
}

base::Outcome<void> VirtualMachine::set_time(double value) {
  constexpr double kMostTime = 235959;
  const auto time = static_cast<int>(std::clamp(value, 0.0, kMostTime));
  if (time != value || time / 100 % 100 > 59 || time % 100 > 59)
    return unusable(3012, "a time is written hhmmss");
  start_second_ = time / 10000 * 3600 + time / 100 % 100 * 60 + time % 100;
  return {};
}

// Who reads a clock waits until all that was commanded is made: the axes come to rest.
double VirtualMachine::seconds() {
  servo_.finish();
  return servo_.time_s();
}

// The calendar of the machine runs with its simulated time: same input, same output.
double VirtualMachine::date() {
  const double total = start_second_ + seconds();
  const std::chrono::year_month_day day{
      start_day_ + std::chrono::days{static_cast<int>(total / kSecondsPerDay)}};
  return static_cast<int>(day.year()) * 10000.0 + static_cast<unsigned>(day.month()) * 100.0 +
         static_cast<unsigned>(day.day());
}

double VirtualMachine::time_of_day() {
  const double second = std::fmod(std::floor(start_second_ + seconds()), kSecondsPerDay);
  return std::floor(second / 3600) * 10000 + std::floor(std::fmod(second, 3600) / 60) * 100 +
         std::fmod(second, 60);
}

std::optional<control::Refusal> VirtualMachine::refusal(const base::AxisVector& from,
                                                        const control::Motion& move,
                                                        Intent intent) {
  if (!reach_) return std::nullopt;
  base::AxisVector end;
  if (auto fault = reach_->objection(from, move, end))
    return control::Refusal{kinematics::code_of(fault->kind), std::move(fault->message)};
  if (intent == Intent::make) reach_->set_joints(end);
  return std::nullopt;
}

// Contacts are used up in order: the next one waits until a probing move passes it.
std::optional<double> VirtualMachine::contact(const base::AxisVector& from,
                                              const base::AxisVector& to) {
  if (contacts_.empty()) return std::nullopt;
  const SkipContact& next = contacts_.front();
  const double begin = from[next.axis];
  const double end = to[next.axis];
  const bool passed = (begin <= next.machine && next.machine <= end) ||
                      (end <= next.machine && next.machine <= begin);
  if (!passed) return std::nullopt;
  const double fraction = begin == end ? 0 : (next.machine - begin) / (end - begin);
  contacts_.pop_front();
  return fraction;
}

void VirtualMachine::print(std::string_view text) {
  if (print_output_) print_output_(text);
}

bool VirtualMachine::all_motions_made() const {
  return most_motions_ != 0 && statistics_.motions() >= most_motions_;
}

// A block may make any number of motions: between them the clock is looked at, too.
bool VirtualMachine::ready() const {
  return !motions_spent_ && !servo_.broken_off() && statistics_.motions() < slice_end_;
}

// Beyond the budget nothing is handed out any more. What moves nothing may still follow its last
// motion: above all the end of the program.
void VirtualMachine::take(const control::Motion& motion) {
  motions_spent_ |= all_motions_made() && control::target_of(motion) != nullptr;
  if (motions_spent_) return;
  statistics_.take(motion);
  servo_.take(motion);
  for (control::MotionSink* const sink : sinks_) sink->take(motion);
}

bool VirtualMachine::start_program() {
  const std::vector<base::Diagnostic>& findings = library_.findings();
  if (!findings.empty()) {
    alarm_ = findings.front();
  } else if (library_.program_count() == 0) {
    alarm_ =
        base::make_error(base::Code::empty_program, {.file = main_file_, .line = 1, .column = 1});
  }
  if (alarm_) {
    alarm_->program = program_name();
    return false;
  }
  controller_->start(vm::CodeId{0});
  const std::span<double> locals = controller_->running_locals();
  for (std::size_t i = 0; i < locals.size(); ++i) {
    if (!vm::is_null(first_locals_[i])) locals[i] = first_locals_[i];
  }
  first_locals_.fill(vm::kNull);
  return true;
}

VirtualMachine::Status VirtualMachine::finish(Status status) {
  if (status == Status::alarm && !alarm_) alarm_ = controller_->alarm();
  servo_.finish();
  return status_ = servo_.broken_off() ? broken_off(status) : status;
}

// What the drives could not do comes before all that the control has met since.
VirtualMachine::Status VirtualMachine::broken_off(Status status) {
  if (drive_alarm_) {
    alarm_ = drive_alarm_;
    return Status::alarm;
  }
  note_spent(base::number_text(most_seconds_) + " s of computing are over");
  return status == Status::alarm ? status : Status::budget;
}

void VirtualMachine::note_spent(const std::string& what) {
  notice_ = base::make_error(base::Code::budget_spent, controller_->standing_at(), what);
  notice_->severity = base::Severity::warning;
  notice_->program = controller_->running_program();
}

VirtualMachine::Status VirtualMachine::spent(const std::string& what) {
  note_spent(what);
  return finish(Status::budget);
}

// One motion may have any number of set-points: between them the clock is looked at, too.
void VirtualMachine::watch_clock(std::chrono::steady_clock::time_point begin, double seconds) {
  most_seconds_ = seconds;
  servo_.break_off_when([this, begin, seconds] {
    if (progress_) progress_();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return seconds > 0 && elapsed.count() > seconds;
  });
}

VirtualMachine::Status VirtualMachine::go(const Budget& budget, bool batch) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  most_motions_ = budget.motions;
  watch_clock(begin, budget.seconds);
  const bool fresh = status_ == Status::idle || status_ == Status::end;
  if (status_ == Status::alarm) return status_;
  if (status_ == Status::end) reset();
  if (fresh && !start_program()) return finish(Status::alarm);
  for (std::uint64_t steps = 0;;) {
    const std::uint64_t slice = budget.steps != 0 ? std::min(kSlice, budget.steps) : kSlice;
    slice_end_ = statistics_.motions() + kSlice;
    if (most_motions_ != 0 && !all_motions_made()) slice_end_ = std::min(slice_end_, most_motions_);
    const Halt halt = controller_->run(slice);
    steps += slice;
    if (progress_) progress_();
    if (halt == Halt::none && servo_.broken_off()) return finish(Status::budget);
    if (motions_spent_) return spent("the motions allowed are made");
    switch (halt) {
      case Halt::end: return finish(Status::end);
      case Halt::alarm: return finish(Status::alarm);
      case Halt::optional_stop: return finish(Status::stopped);
      case Halt::single_block:
      case Halt::program_stop:
      case Halt::message:
        if (!batch) return finish(Status::running);
        break;
      case Halt::none: break;
    }
    if (budget.steps != 0 && steps >= budget.steps) return spent("the steps allowed are made");
    const std::chrono::duration<double> elapsed = Clock::now() - begin;
    if (budget.seconds > 0 && elapsed.count() > budget.seconds) {
      return spent(base::number_text(budget.seconds) + " s of computing are over");
    }
  }
}

VirtualMachine::Status VirtualMachine::cycle_start(const Budget& budget) {
  return go(budget, false);
}

VirtualMachine::Status VirtualMachine::run_to_end(const Budget& budget) { return go(budget, true); }

void VirtualMachine::reset() {
  controller_->reset();
  alarm_.reset();
  drive_alarm_.reset();
  servo_.resume();
  notice_.reset();
  status_ = Status::idle;
}

}  // namespace kerf::machine
