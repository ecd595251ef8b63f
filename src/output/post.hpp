#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "control/plane_axes.hpp"
#include "geometry/space_arc.hpp"
#include "machine/drive_settings.hpp"

namespace kerf::output {

/// Writes the executed path as plain G-code for controllers without macros: no variables, no
/// cycles, no compensation, one tool centre path in machine coordinates, mm and degrees (G21 G90
/// G94), arcs with I, J, K, coordinates with a point, dwell in seconds. Arcs in space that lie in
/// XY, ZX or YZ while nothing else moves are arcs as well; others are chords that leave them by at
/// most kChordTolerance_mm, rounding of the coordinates apart. Whole circles more are full circles
/// before their arc.
///
/// The beam of a laser is its M3 or M4 with S, and M5 - M4 where the power follows the speed, or
/// LaserSettings::post_beam says so; S is percent of full power times
/// LaserSettings::s_of_full_power. What plain G-code cannot say - M codes of the machine, messages,
/// that a move probes or cuts a thread, power on a machine without a laser - is a comment with its
/// source line.
class Post : public control::MotionSink {
 public:
  static constexpr double kChordTolerance_mm = 0.001;

  /// Axes and file must outlive this.
  Post(const control::AxisSetup& axes, base::OutputFile& file,
       const machine::LaserSettings& laser = {});
  void take(const control::Motion& motion) override;
  /// Writes the end, unless the program's own has been written.
  void finish();
  /// How much was only a comment, for people: an indented line, or nothing.
  [[nodiscard]] std::string remark() const;

 private:
  void act(const control::Rapid& rapid);
  void act(const control::Line& line);
  void act(const control::Arc& arc);
  void act(const control::SpaceArc& arc);
  void act(const control::Dwell& dwell);
  void act(const control::ToolChange& change);
  void act(const control::Spindle& spindle);
  void act(const control::Coolant& coolant);
  void act(const control::Power& power);
  void act(const control::Probe& probe);
  void act(const control::Thread& thread);
  void act(const control::AuxiliaryCode& code);
  void act(const control::Stop& stop);
  void act(const control::Message& message);
  void act(const control::End& end);

  void comment(const std::string& text);
  void block(const std::string& text);
  void move(const char* code, const base::AxisVector& to);
  void feed(double per_minute);
  void tell_override(const control::Motion& motion);
  [[nodiscard]] std::optional<double> flat_rise(const control::Arc& arc,
                                                const control::PlaneAxes& plane) const;
  void flat_arc(const control::Arc& arc, const control::PlaneAxes& plane, double rise);
  void line(const base::AxisVector& to, double per_minute);
  void straight(const base::AxisVector& to, const control::Feed& rate);
  void full_circles(const control::Arc& arc, const control::PlaneAxes& plane, double per_minute);
  void sweep(const control::Arc& arc, const control::PlaneAxes& plane, double per_minute);
  [[nodiscard]] std::optional<control::Arc> plane_arc(const control::SpaceArc& arc,
                                                      const geometry::SpaceArc& circle,
                                                      control::Plane plane) const;
  void select_plane(control::Plane plane);
  [[nodiscard]] bool rounded_equal(const base::AxisVector& a, const base::AxisVector& b) const;
  void word(char letter, double value);
  void coordinate(char letter, double value);
  void end_block();

  const control::AxisSetup& axes_;
  base::OutputFile& file_;
  std::string line_;
  base::AxisVector at_;
  bool moved_ = false;
  std::string modal_;
  control::Plane plane_ = control::Plane::xy;
  double feed_ = -1;
  double speed_rpm_ = 0;
  std::string turning_;  // the block that switched spindle or beam on; empty: off
  bool fixed_ = false;   // the last move had a feed without override
  bool css_ = false;     // G96 is on
  machine::LaserSettings laser_;
  double s_ = -1;  // of the laser
  bool beam_on_ = false;
  bool cuts_ = false;  // a cut or G1 has turned on the beam
  std::uint32_t source_line_ = 0;
  std::size_t only_comments_ = 0;
  std::uint32_t first_comment_line_ = 0;
  bool ended_ = false;
};

}  // namespace kerf::output
