#include "output/step_pulses.hpp"

#include "output/drive_alarm.hpp"

namespace kerf::output {

StepPulses::StepPulses(machine::VirtualMachine& machine, drive::PulseSink& into)
    : machine_(machine),
      generator_(machine.definition().step_axes(), machine.definition().drive.timing, into) {}

void StepPulses::start(const machine::AxisPoint& at) {
  generator_.start({at.tip.time_s, at.joints});
}

void StepPulses::take(const machine::AxisPoint& point) {
  if (auto made = generator_.move_to({point.tip.time_s, point.joints}); !made)
    machine_.raise(at_mark(std::move(made.error()), point.tip.mark, machine_.sources()));
}

}  // namespace kerf::output
