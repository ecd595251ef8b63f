#pragma once

#include "drive/step_generator.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/axis_point.hpp"
#include "output/writing/drive_fault.hpp"

namespace kerf::output {

/// Makes the step pulses of a machine's motors from its set-points, one motor for each driven axis
/// with the steps, rates and times of the machine file (docs/drives.md, "Steps along a line").
///
/// What a motor or its amplifier cannot do is a fault, STEP_RATE, at that set-point. The pulses up
/// to the one before have been made then.
class StepPulses : public motion::AxisPointSink {
 public:
  /// `into` must outlive this.
  StepPulses(const machine::MachineDefinition& machine, DriveFault fault, drive::PulseSink& into);

  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;

 private:
  DriveFault fault_;
  drive::StepGenerator generator_;
};

}  // namespace kerf::output
