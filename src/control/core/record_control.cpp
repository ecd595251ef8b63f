#include "control/core/record_control.hpp"

#include <utility>

namespace kerf::control {

using vm::Verdict;

RecordControl::RecordControl(vm::CodeSource& records, motion::MotionSink& sink)
    : sink_(sink), interpreter_(records, *this, {}) {}

void RecordControl::stand_at_head(vm::CodeId program, std::string name) {
  name_ = std::move(name);
  interpreter_.start(program);
  halt_ = Halt::none;
}

void RecordControl::reset() {
  alarms_.clear();
  halt_ = Halt::none;
}

Halt RecordControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  interpreter_.run(instructions);
  if (alarms_.alarm()) halt_ = Halt::alarm;
  return halt_;
}

Verdict RecordControl::behind_record() {
  if (single_block_) return halt_with(Halt::single_block, Verdict::pause);
  return sink_.ready() ? Verdict::go_on : Verdict::pause;
}

Verdict RecordControl::read(double /*number*/, double& /*value*/) { return Verdict::stop; }
Verdict RecordControl::write(double /*number*/, double /*value*/) { return Verdict::stop; }
void RecordControl::fault(vm::Fault /*fault*/) {}

}  // namespace kerf::control
