#include "machine/virtual_machine.hpp"

#include <cmath>
#include <filesystem>

#include "base/decimal.hpp"

namespace kerf::machine {
namespace {

using control::Halt;

// Instructions between two looks at the clock: some milliseconds.
constexpr std::uint64_t kSlice = 200'000;
constexpr double kSecondsPerDay = 86400;

}  // namespace

VirtualMachine::VirtualMachine(const MachineDefinition& definition, control::Memory memory,
                               const Settings& settings)
    : definition_(definition),
      memory_(std::move(memory)),
      library_(sources_, settings.library),
      shelf_(sources_, library_),
      statistics_(definition_.axes) {
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
  const gcode::ProgramEntry& entry = library_.entry(vm::CodeId{0});
  if (!entry.name.empty()) return entry.name;
  std::string digits = std::to_string(entry.number);
  return "O" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

base::Outcome<void> VirtualMachine::set_variable(std::uint32_t number, double value) {
  const double rounded = std::round(value);
  if (number >= 1000 && number <= 1035) {
    const std::uint32_t word = number < 1016 ? 0 : number >= 1032 ? number - 1032 : 4;
    if (word == 4 || rounded < -2147483648.0 || rounded > 4294967295.0) {
      return tl::unexpected(base::Failure{
          base::Failure::Kind::usage, "#" + std::to_string(number) + ": there is no such input"});
    }
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(rounded));
    if (number >= 1032) {
      inputs_[word] = number == 1032 ? bits & 0xffffU : bits;
    } else {
      const std::uint32_t bit = 1U << (number - 1000);
      inputs_[0] = value != 0 ? inputs_[0] | bit : inputs_[0] & ~bit;
    }
    return {};
  }
  if (number == 3011) {
    const auto date = static_cast<int>(rounded);
    const std::chrono::year_month_day day{
        std::chrono::year{date / 10000},
        std::chrono::month{static_cast<unsigned>(date / 100 % 100)},
        std::chrono::day{static_cast<unsigned>(date % 100)}};
    if (!day.ok() || rounded != value)
      return tl::unexpected(
          base::Failure{base::Failure::Kind::usage, "#3011: a date is written yyyymmdd"});
    start_day_ = day;
    return {};
  }
  if (number == 3012) {
    const auto time = static_cast<int>(rounded);
    start_second_ = time / 10000 * 3600 + time / 100 % 100 * 60 + time % 100;
    return {};
  }
  return controller_->set_variable(number, value);
}

// The calendar of the machine runs with its simulated time: same input, same output.
double VirtualMachine::date() {
  const double total = start_second_ + statistics_.seconds();
  const std::chrono::year_month_day day{
      start_day_ + std::chrono::days{static_cast<int>(total / kSecondsPerDay)}};
  return static_cast<int>(day.year()) * 10000.0 + static_cast<unsigned>(day.month()) * 100.0 +
         static_cast<unsigned>(day.day());
}

double VirtualMachine::time_of_day() {
  const double second =
      std::fmod(std::floor(start_second_ + statistics_.seconds()), kSecondsPerDay);
  return std::floor(second / 3600) * 10000 + std::floor(std::fmod(second, 3600) / 60) * 100 +
         std::fmod(second, 60);
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

// Beyond the budget nothing is handed out any more.
void VirtualMachine::take(const control::Motion& motion) {
  if (motions_spent_) return;
  statistics_.take(motion);
  for (control::MotionSink* const sink : sinks_) sink->take(motion);
  motions_spent_ = most_motions_ != 0 && statistics_.motions() >= most_motions_;
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
  return true;
}

VirtualMachine::Status VirtualMachine::finish(Status status) {
  if (status == Status::alarm && !alarm_) alarm_ = controller_->alarm();
  return status_ = status;
}

VirtualMachine::Status VirtualMachine::spent(const std::string& what) {
  notice_ = base::make_error(base::Code::budget_spent, controller_->standing_at(), what);
  notice_->severity = base::Severity::warning;
  notice_->program = controller_->running_program();
  return finish(Status::budget);
}

VirtualMachine::Status VirtualMachine::go(const Budget& budget, bool batch) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  most_motions_ = budget.motions;
  const bool fresh = status_ == Status::idle || status_ == Status::end;
  if (status_ == Status::alarm) return status_;
  if (status_ == Status::end) reset();
  if (fresh && !start_program()) return finish(Status::alarm);
  for (std::uint64_t steps = 0;;) {
    const std::uint64_t slice = budget.steps != 0 ? std::min(kSlice, budget.steps) : kSlice;
    const Halt halt = controller_->run(slice);
    steps += slice;
    if (progress_) progress_();
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
    if (motions_spent_) return spent("the motions allowed are made");
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
  notice_.reset();
  status_ = Status::idle;
}

}  // namespace kerf::machine
