#include "control/teach/teach_control.hpp"

#include <utility>

namespace kerf::control {

using vm::Verdict;

TeachControl::TeachControl(const motion::AxisSetup& axes, const TaughtFor& machine,
                           teach::TeachLibrary& library, Surroundings& surroundings,
                           motion::MotionSink& sink)
    : RecordControl(library, sink),
      checks_strokes_(machine.checks_strokes),
      strokes_(axes, checks_strokes_, nullptr),
      outlet_(alarms_, surroundings,
              axes.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, &strokes_,
              sink),
      moves_(axes, alarms_, assumptions_, outlet_, machine) {}

void TeachControl::start(std::string name) {
  moves_.reset();
  stand_at_head(teach::TeachLibrary::kProgram, std::move(name));
}

void TeachControl::reset() {
  RecordControl::reset();
  moves_.reset();
}

// vm::Host

Verdict TeachControl::execute(const vm::CodePage& page, std::uint32_t block,
                              const double* /*registers*/) {
  const auto& taught = static_cast<const teach::TeachPage&>(page);
  const teach::Block& record = taught.blocks[block];
  ++blocks_;
  if (!moves_.execute(record, this->block())) return Verdict::stop;
  if (std::holds_alternative<teach::End>(record.record)) return halt_with(Halt::end, Verdict::stop);
  return behind_record();
}

// The compiler ends every program with END or a failure, behind which only a search comes here.
Verdict TeachControl::end_of_code() { return halt_with(Halt::end, Verdict::stop); }

}  // namespace kerf::control
