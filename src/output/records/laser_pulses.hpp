#pragma once

#include "base/output_file.hpp"
#include "drive/pwm_csv.hpp"
#include "machine/definition/drive_settings.hpp"
#include "motion/axis_point.hpp"
#include "output/writing/drive_fault.hpp"

namespace kerf::output {

/// Writes how the timer of a machine's laser runs, as CSV: drive::PwmCsv, a row a change.
///
/// The duty is the power that is commanded, of full power; the frequency that of the program,
/// or of the machine file where it says none. A change counts from the set-point before the first
/// one of the motion that has it: where the axes rest between the two motions that is the moment
/// itself, else up to a period early. The first row is how the run begins.
class LaserPulses : public motion::AxisPointSink {
 public:
  /// What the timer cannot do is a fault, PWM_RANGE. Laser and file must outlive this.
  /// Precondition: the laser is fitted.
  LaserPulses(const machine::LaserSettings& laser, DriveFault fault, base::OutputFile& file);

  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;
  /// The end of the run: the beam goes off with it. The last call.
  void finish();

 private:
  void change(double power_percent, const motion::Mark& mark);

  const machine::LaserSettings& laser_;
  DriveFault fault_;
  drive::PwmCsv csv_;
  motion::Setpoint last_;
  float power_percent_ = -1;  // nothing yet
  double frequency_hz_;
};

}  // namespace kerf::output
