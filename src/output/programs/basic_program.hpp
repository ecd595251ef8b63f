#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::output {

/// Writes motions as a program of laser BASIC (docs/laser-basic.md), mm and mm/s from the work
/// origin: rapids are MOVE, cuts LINE and ARC (by the end and the radius, from half a circle on by
/// centre and angles), whole circles CIRCLE or ARC, dwells WAIT or, with the beam on, BURN, air
/// AIR. A cut without beam is one at POWER(0). What the language cannot say is a comment and in
/// lost(): power that follows the speed, other axes than X Y Z.
class BasicProgram : public motion::MotionSink {
 public:
  /// Axes and file must outlive this; `title` as people call what is made.
  BasicProgram(const motion::AxisSetup& axes, const std::string& title, base::OutputFile& file);

  void take(const motion::Motion& motion) override;
  void comment(const std::string& text);
  /// Writes END, unless the program's own has been written.
  void finish();
  /// Each thing once.
  [[nodiscard]] const std::vector<std::string>& lost() const { return lost_; }

 private:
  void act(const motion::Rapid& rapid);
  void act(const motion::Line& line);
  void act(const motion::Arc& arc);
  void act(const motion::Dwell& dwell);
  void act(const motion::Coolant& coolant);
  void act(const motion::Power& power);
  void act(const motion::Message& message);
  void act(const motion::End& end);
  template <typename Other>
  void act(const Other& /*other*/) {
    lose("a motion that laser BASIC has no statement for");
  }

  void statement(const char* name, const std::vector<double>& values);
  void go(const char* name, const base::TipPoint& to);
  void cut_at(const motion::Feed& feed);
  void lose(const std::string& what);

  const motion::AxisSetup& axes_;
  base::OutputFile& file_;
  base::TipPoint at_;
  motion::Power power_{0};
  double written_percent_ = -1;
  double power_hz_ = 0;  // 0: that of the machine
  double written_feed_ = 0;
  std::vector<std::string> lost_;
  bool has_ended_ = false;
};

}  // namespace kerf::output
