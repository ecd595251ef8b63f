#pragma once

#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "geometry/space_arc.hpp"

namespace kerf::output {

/// Writes the executed path as plain G-code for controllers without macros: no variables, no
/// cycles, no compensation, one tool centre path in machine coordinates, mm and degrees (G21 G90
/// G94), arcs with I, J, K, dwell in seconds. Arcs in space that lie in XY, ZX or YZ while nothing
/// else moves are arcs as well; others are chords that leave them by at most kChordTolerance_mm,
/// rounding of the coordinates apart. The power of a laser is a comment: no word of plain G-code
/// says it.
class Post : public control::MotionSink {
 public:
  static constexpr double kChordTolerance_mm = 0.001;

  Post(const control::AxisSetup& axes, base::OutputFile& file);
  void take(const control::Motion& motion) override;
  /// Writes the end, unless the program's own has been written.
  void finish();

 private:
  void write(const control::Motion& motion);
  void move(const char* code, const base::AxisVector& to);
  void feed(const control::Feed& feed, double length_mm);
  void line(const base::AxisVector& to, const control::Feed& rate, double length_mm);
  void arc(const control::Arc& arc);
  void space_arc(const control::SpaceArc& arc);
  [[nodiscard]] std::optional<control::Arc> plane_arc(const control::SpaceArc& arc,
                                                      const geometry::SpaceArc& circle,
                                                      control::Plane plane) const;
  void spindle(const control::Spindle& spindle);
  void select_plane(control::Plane plane);
  [[nodiscard]] bool rounded_equal(const base::AxisVector& a, const base::AxisVector& b) const;
  void word(char letter, double value);
  void end_block();

  const control::AxisSetup& axes_;
  base::OutputFile& file_;
  std::string line_;
  base::AxisVector at_;
  std::string modal_;
  control::Plane plane_ = control::Plane::xy;
  double feed_ = -1;
  double speed_rpm_ = 0;
  bool css_ = false;  // G96 is on
  bool ended_ = false;
};

}  // namespace kerf::output
