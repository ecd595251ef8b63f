#pragma once

#include <memory>
#include <string>

#include "base/output_file.hpp"
#include "control/axis_setup.hpp"
#include "control/motion.hpp"

namespace kerf::output {

/// Writes motions as JSON Lines (docs/command-line.md): one object a line, in order. mm,
/// degrees, mm/min.
class MotionJson : public control::MotionSink {
 public:
  MotionJson(const control::AxisSetup& axes, base::OutputFile& file);
  void take(const control::Motion& motion) override;

 private:
  void begin(const char* kind, const control::Motion& motion);
  void point(const char* name, const base::AxisVector& at);
  void target(const base::AxisVector& to) { point(",\"to\":{", to); }
  void space_arc(const control::SpaceArc& arc);
  void feed(const control::Feed& feed);
  void write(const control::Motion& motion);

  const control::AxisSetup& axes_;
  base::OutputFile& file_;
  base::AxisVector at_;
  std::vector<std::string> keys_;  // per axis: what stands before its value
  std::string line_;
  std::string program_;  // text of the newest program number
  control::ProgramNumber program_number_{0xffffffffU};
};

}  // namespace kerf::output
