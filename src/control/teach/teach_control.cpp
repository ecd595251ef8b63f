#include "control/teach/teach_control.hpp"

#include <utility>

namespace kerf::control {

using vm::Verdict;

TeachControl::TeachControl(const motion::AxisSetup& axes, const TaughtFor& machine,
                           teach::TeachLibrary& library, Surroundings& surroundings,
                           motion::MotionSink& sink)
    : sink_(sink),
      checks_strokes_(machine.checks_strokes),
      strokes_(axes, checks_strokes_, nullptr),
      outlet_(alarms_, surroundings,
              axes.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, &strokes_,
              sink),
      moves_(axes, alarms_, assumptions_, outlet_, machine),
      interpreter_(library, *this, {}) {}

void TeachControl::start(std::string name) {
  name_ = std::move(name);
  moves_.reset();
  interpreter_.start(teach::TeachLibrary::kProgram);
  halt_ = Halt::none;
}

void TeachControl::reset() {
  alarms_.clear();
  moves_.reset();
  halt_ = Halt::none;
}

Halt TeachControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  interpreter_.run(instructions);
  if (alarms_.alarm()) halt_ = Halt::alarm;
  return halt_;
}

// vm::Host

Verdict TeachControl::execute(const vm::CodePage& page, std::uint32_t block,
                              const double* /*registers*/) {
  const auto& taught = static_cast<const teach::TeachPage&>(page);
  const teach::Block& record = taught.blocks[block];
  ++blocks_;
  if (!moves_.execute(record, this->block())) return Verdict::stop;
  if (std::holds_alternative<teach::End>(record.record)) return halt_with(Halt::end, Verdict::stop);
  if (single_block_) return halt_with(Halt::single_block, Verdict::pause);
  return sink_.ready() ? Verdict::go_on : Verdict::pause;
}

// The compiler ends every program with END or a failure, behind which only a search comes here; it
// makes no code that reads, writes or calculates.
Verdict TeachControl::end_of_code() { return halt_with(Halt::end, Verdict::stop); }
Verdict TeachControl::read(double /*number*/, double& /*value*/) { return Verdict::stop; }
Verdict TeachControl::write(double /*number*/, double /*value*/) { return Verdict::stop; }
void TeachControl::fault(vm::Fault /*fault*/) {}

}  // namespace kerf::control
