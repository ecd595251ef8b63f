#pragma once

#include <optional>
#include <string>

#include "base/output_file.hpp"
#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "control/space_arc_path.hpp"
#include "lang/teach/record.hpp"
#include "machine/virtual_machine.hpp"
#include "output/internal/round_way.hpp"

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
/// feed is not known in mm/min (G95 without a speed) raises the machine's alarm TEACH_RANGE.
class TaughtProgram : public control::MotionSink {
 public:
  static constexpr double kTolerance_mm = 0.001;

  /// Both must outlive this. Precondition: can_say() of the machine's axes.
  TaughtProgram(machine::VirtualMachine& machine, base::OutputFile& file);

  /// Whether every axis is X, Y, Z, A or C.
  [[nodiscard]] static bool can_say(const control::AxisSetup& axes);

  void take(const control::Motion& motion) override;
  /// Writes END, unless the program's own has been written.
  void finish();

 private:
  void act(const control::Rapid& rapid);
  void act(const control::Line& line);
  void act(const control::Arc& arc);
  void act(const control::SpaceArc& arc);
  void act(const control::Dwell& dwell);
  void act(const control::Power& power);
  void act(const control::Probe& probe);
  void act(const control::Thread& thread);
  void act(const control::Spindle& spindle);
  void act(const control::ToolChange& change);
  void act(const control::Coolant& coolant);
  void act(const control::AuxiliaryCode& code);
  void act(const control::Stop& stop);
  void act(const control::Message& message);
  void act(const control::End& end);

  bool feed(const control::Feed& feed, double length_mm);
  void cut(const base::AxisVector& to, const control::Feed& rate, double length_mm);
  void begin_path();
  [[nodiscard]] std::optional<teach::Arc> arc_over(const RoundWay& way, double begin,
                                                   double end) const;
  bool arcs(const RoundWay& way, double count);
  bool circles(const RoundWay& way);
  void chords(const RoundWay& way);
  void write(const teach::Record& record);
  void comment(const std::string& text);
  [[nodiscard]] teach::Pose pose(const base::AxisVector& at) const;
  [[nodiscard]] double length_to(const base::AxisVector& to) const;

  machine::VirtualMachine& machine_;
  const control::AxisSetup& axes_;
  base::OutputFile& file_;
  std::string line_;
  base::AxisVector at_;
  const control::Motion* motion_ = nullptr;  // that is being taken
  double feed_ = 0;                          // last FEED; 0: none
  double speed_rpm_ = 0;
  bool begun_ = false;  // a POINT has been written
  bool ended_ = false;
};

}  // namespace kerf::output
