#include "output/records/step_pulses.hpp"

#include <utility>

namespace kerf::output {

StepPulses::StepPulses(const machine::MachineDefinition& machine, DriveFault fault,
                       drive::PulseSink& into)
    : fault_(std::move(fault)), generator_(machine.step_axes(), machine.drive.timing, into) {}

void StepPulses::start(const motion::AxisPoint& at) {
  generator_.start({at.tip.time_s, at.joints});
}

void StepPulses::take(const motion::AxisPoint& point) {
  if (auto made = generator_.move_to({point.tip.time_s, point.joints}); !made)
    fault_(made.error(), point.tip.mark);
}

}  // namespace kerf::output
