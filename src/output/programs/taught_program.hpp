#pragma once

#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "lang/teach/record.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/space_arc_path.hpp"
#include "output/programs/internal/round_way.hpp"
#include "output/writing/drive_fault.hpp"

namespace kerf::output {

/// Writes the executed path as taught points (docs/teach.md), tool tip in machine coordinates:
/// rapids are POINTs, cuts LINE, ARC and CIRCLE with their feed in mm/min, dwells and the laser's
/// power are themselves. Arcs of a plane are ARC through the middle of the way, full circles
/// CIRCLE; other axes may turn with them.
///
/// A helix, and an arc whose radius changes by more than kTolerance_mm, is chords that leave it by
/// at most kTolerance_mm. Every other arc leaves its place by at most that as well: it is looked at
/// before it is written, and is chords where its three points would not carry it. What taught
/// points cannot say (tools, spindle, coolant, M codes, stops, messages) is a comment. A cut whose
/// feed is not known in mm/min (G95 without a speed) is a fault, TEACH_RANGE.
class TaughtProgram : public motion::MotionSink {
 public:
  static constexpr double kTolerance_mm = 0.001;

  /// What its first records say of the machine.
  struct Head {
    double period_ms = 0;
    std::optional<teach::Radii> radii;
  };

  /// Axes and file must outlive this. Precondition: can_say() of the axes.
  TaughtProgram(const motion::AxisSetup& axes, const Head& head, DriveFault fault,
                base::OutputFile& file);

  /// Whether every axis is X, Y, Z, A or C.
  [[nodiscard]] static bool can_say(const motion::AxisSetup& axes);

  void take(const motion::Motion& motion) override;
  /// Writes END, unless the program's own has been written.
  void finish();

 private:
  void act(const motion::Rapid& rapid);
  void act(const motion::Line& line);
  void act(const motion::Arc& arc);
  void act(const motion::SpaceArc& arc);
  void act(const motion::SurfaceMove& move);
  void act(const motion::Dwell& dwell);
  void act(const motion::Power& power);
  void act(const motion::Probe& probe);
  void act(const motion::Thread& thread);
  void act(const motion::Spindle& spindle);
  void act(const motion::ToolChange& change);
  void act(const motion::Coolant& coolant);
  void act(const motion::AuxiliaryCode& code);
  void act(const motion::Stop& stop);
  void act(const motion::Message& message);
  void act(const motion::End& end);

  bool feed(const motion::Feed& feed, double length_mm);
  void cut(const base::TipPoint& to, const motion::Feed& rate, double length_mm);
  void begin_path();
  [[nodiscard]] std::optional<teach::Arc> arc_over(const RoundWay& way, double begin,
                                                   double end) const;
  bool arcs(const RoundWay& way, double count);
  bool circles(const RoundWay& way);
  void chords(const RoundWay& way);
  void write(const teach::Record& record);
  void comment(const std::string& text);
  [[nodiscard]] teach::Pose pose(const base::TipPoint& at) const;
  [[nodiscard]] double length_to(const base::TipPoint& to) const;

  const motion::AxisSetup& axes_;
  DriveFault fault_;
  base::OutputFile& file_;
  std::string line_;
  base::TipPoint at_;
  const motion::Motion* motion_ = nullptr;  // that is being taken
  double feed_ = 0;                         // last FEED; 0: none
  double speed_rpm_ = 0;
  bool begun_ = false;  // a POINT has been written
  bool ended_ = false;
};

}  // namespace kerf::output
