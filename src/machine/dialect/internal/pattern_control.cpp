#include "machine/dialect/internal/pattern_control.hpp"

#include <optional>
#include <utility>

namespace kerf::machine {

using control::Halt;
using vm::Verdict;

PatternControl::PatternControl(const PatternMachine& machine, PatternLibrary& library,
                               PatternQueue& records, motion::MotionSink& sink)
    : machine_(machine),
      records_(records),
      sink_(sink),
      motors_(machine, counted_),
      interpreter_(library, *this, {}) {}

void PatternControl::start(std::string name) {
  name_ = std::move(name);
  motors_ = PatternMotors(machine_, counted_);
  interpreter_.start(PatternLibrary::kProgram);
  halt_ = Halt::none;
  is_open_ = true;
}

void PatternControl::reset() {
  alarms_.clear();
  halt_ = Halt::none;
  is_open_ = false;
}

Halt PatternControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  interpreter_.run(instructions);
  if (alarms_.alarm()) halt_ = Halt::alarm;
  is_open_ = halt_ != Halt::alarm && halt_ != Halt::end;
  return halt_;
}

void PatternControl::hand_out(motion::Motion motion) {
  motion.block = block();
  sink_.take(motion);
}

bool PatternControl::refuse(const PatternMotors& before, base::Diagnostic alarm) {
  motors_ = before;
  alarm.place = place();
  return alarms_.report(std::move(alarm));
}

// What moves nothing takes no time either.
bool PatternControl::command(const drive::PatternRecord& record, bool ends_block) {
  const PatternMotors before = motors_;
  if (auto made = motors_.make(record); !made) return refuse(before, std::move(made.error()));
  for (std::size_t joint = 0; joint < drive::kArmAxes; ++joint) {
    if (!motors_.is_beyond_travel(joint)) continue;
    return refuse(
        before, base::make_error(base::Code::joint_limit, {}, motors_.words_beyond_travel(joint)));
  }
  if (!motors_.motion()) return true;
  records_.push_back({record, before.counters(), ends_block});
  hand_out(*motors_.motion());
  return true;
}

// vm::Host

Verdict PatternControl::execute(const vm::CodePage& page, std::uint32_t block,
                                const double* /*registers*/) {
  ++blocks_;
  std::optional<drive::PatternRecord> last;
  bool good = true;
  drive::each_record(static_cast<const PatternPage&>(page).blocks[block].move,
                     [&](const drive::PatternRecord& record) {
                       if (last) good = good && command(*last, false);
                       last = record;
                     });
  if (last) good = good && command(*last, true);
  if (!good) return Verdict::stop;
  if (single_block_) return halt_with(Halt::single_block, Verdict::pause);
  return sink_.ready() ? Verdict::go_on : Verdict::pause;
}

Verdict PatternControl::end_of_code() {
  motion::Motion end;
  end.action = motion::End{};
  hand_out(end);
  return halt_with(Halt::end, Verdict::stop);
}

// The library makes no code that reads, writes or calculates.
Verdict PatternControl::read(double /*number*/, double& /*value*/) { return Verdict::stop; }
Verdict PatternControl::write(double /*number*/, double /*value*/) { return Verdict::stop; }
void PatternControl::fault(vm::Fault /*fault*/) {}

}  // namespace kerf::machine
