#include "drive/pwm_csv.hpp"

#include "base/decimal.hpp"

namespace kerf::drive {

PwmCsv::PwmCsv(base::OutputFile& file, std::optional<int> timer) : file_(file) {
  const std::string number = timer ? std::to_string(*timer) : "";
  file_.write("t,line,f,duty,TCNTB" + number + ",TCMPB" + number + "\n");
}

void PwmCsv::take(double time_s, std::uint32_t line, const PulseTrain& train,
                  const PwmRegisters& registers) {
  if (train_ == train && registers_ == registers) return;
  train_ = train;
  registers_ = registers;
  line_.clear();
  base::append_number(line_, time_s);
  line_ += ',';
  base::append_integer(line_, line);
  line_ += ',';
  base::append_number(line_, train.frequency_hz);
  line_ += ',';
  base::append_number(line_, train.duty);
  line_ += ',';
  base::append_integer(line_, registers.tcntb);
  line_ += ',';
  base::append_integer(line_, registers.tcmpb);
  line_ += '\n';
  file_.write(line_);
}

}  // namespace kerf::drive
