#include "machine/dialect/internal/pattern_control.hpp"

#include <optional>
#include <utility>

namespace kerf::machine {

using control::Halt;
using vm::Verdict;

PatternControl::PatternControl(const PatternMachine& machine, PatternLibrary& library,
                               PatternQueue& records, motion::MotionSink& sink)
    : RecordControl(library, sink),
      machine_(machine),
      records_(records),
      motors_(machine, counted_) {}

void PatternControl::start(std::string name) {
  motors_ = PatternMotors(machine_, counted_);
  stand_at_head(PatternLibrary::kProgram, std::move(name));
  is_open_ = true;
}

void PatternControl::reset() {
  RecordControl::reset();
  is_open_ = false;
}

Halt PatternControl::run(std::uint64_t instructions) {
  RecordControl::run(instructions);
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
  return behind_record();
}

Verdict PatternControl::end_of_code() {
  motion::Motion end;
  end.action = motion::End{};
  hand_out(end);
  return halt_with(Halt::end, Verdict::stop);
}

}  // namespace kerf::machine
