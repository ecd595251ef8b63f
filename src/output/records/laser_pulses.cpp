#include "output/records/laser_pulses.hpp"

#include <utility>

#include "base/decimal.hpp"

namespace kerf::output {

LaserPulses::LaserPulses(const machine::LaserSettings& laser, DriveFault fault,
                         base::OutputFile& file)
    : laser_(laser),
      fault_(std::move(fault)),
      csv_(file, laser.timer_number),
      frequency_hz_(laser.pwm_frequency_hz) {}

void LaserPulses::start(const motion::AxisPoint& at) { last_ = at.tip; }

void LaserPulses::take(const motion::AxisPoint& point) {
  const motion::Mark& mark = point.tip.mark;
  const double frequency_hz = mark.pulse_hz > 0 ? mark.pulse_hz : laser_.pwm_frequency_hz;
  const bool changes = point.power_percent != power_percent_ || frequency_hz != frequency_hz_;
  power_percent_ = point.power_percent;
  frequency_hz_ = frequency_hz;
  if (changes) change(base::decimal_of(power_percent_), mark);
  last_ = point.tip;
}

void LaserPulses::change(double power_percent, const motion::Mark& mark) {
  const drive::PulseTrain train{frequency_hz_, base::tidy(power_percent / 100)};
  const auto registers = drive::pwm_registers(laser_.timer, train);
  if (registers) {
    csv_.take(base::tidy(last_.time_s), mark.block.line, train, *registers);
  } else {
    fault_(registers.error(), mark);
  }
}

void LaserPulses::finish() {
  if (power_percent_ > 0) change(0, last_.mark);
}

}  // namespace kerf::output
