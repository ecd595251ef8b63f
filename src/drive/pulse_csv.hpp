#pragma once

#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "drive/pulse_sink.hpp"

namespace kerf::drive {

/// Writes pulses as CSV, a line each: `time_ns,axis,direction`, the time of the rising edge, the
/// axis's name, 1 or -1.
class PulseCsv : public PulseSink {
 public:
  /// One name per axis, in the machine's order. The file must outlive the writer.
  PulseCsv(const std::vector<std::string>& axis_names, base::OutputFile& file);
  void take(const Pulse& pulse) override;

 private:
  base::OutputFile& file_;
  std::vector<std::string> ends_;  // per axis and direction: what follows the time
  std::string line_;
};

}  // namespace kerf::drive
