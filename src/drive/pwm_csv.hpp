#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "drive/pwm.hpp"

namespace kerf::drive {

/// Writes the laser's pulses as CSV: `t,line,f,duty,TCNTB,TCMPB`, a row for each change of anything
/// but time and line. s, source line, commanded Hz and duty (0 to 1), registers. Where the timer is
/// known by its number, the head names its registers: `TCNTB2,TCMPB2`.
class PwmCsv {
 public:
  /// The file must outlive the writer.
  explicit PwmCsv(base::OutputFile& file, std::optional<int> timer = {});

  /// From `time_s` on the timer runs so.
  void take(double time_s, std::uint32_t line, const PulseTrain& train,
            const PwmRegisters& registers);

 private:
  base::OutputFile& file_;
  std::optional<PulseTrain> train_;
  PwmRegisters registers_;
  std::string line_;
};

}  // namespace kerf::drive
