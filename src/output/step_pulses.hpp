#pragma once

#include "drive/step_generator.hpp"
#include "machine/axis_point.hpp"
#include "machine/virtual_machine.hpp"

namespace kerf::output {

/// Makes the step pulses of a machine's motors from its set-points, one motor for each driven axis
/// with the steps, rates and times of the machine file (docs/drives.md, "Steps along a line").
///
/// What a motor or its amplifier cannot do raises the machine's alarm STEP_RATE at the source line
/// of that set-point. The pulses up to the one before have been made then.
class StepPulses : public machine::AxisPointSink {
 public:
  /// Both must outlive this.
  StepPulses(machine::VirtualMachine& machine, drive::PulseSink& into);

  void start(const machine::AxisPoint& at) override;
  void take(const machine::AxisPoint& point) override;

 private:
  machine::VirtualMachine& machine_;
  drive::StepGenerator generator_;
};

}  // namespace kerf::output
