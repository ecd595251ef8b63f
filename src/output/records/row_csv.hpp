#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/output_file.hpp"
#include "control/core/memory.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::output {

/// Writes motions as the canonical rows of feature recognition, CSV:
/// `line,G,X,Y,Z,I,J,K,R,T,F,A`, a row for each move and each tool change.
///
///   line   source line
///   G      0 rapid, 1 line, 2 arc clockwise, 3 counterclockwise, 31 probing move, 33 thread; T
///   tool
///          change
///   X Y Z  where it ends: the tool tip in machine coordinates; an axis that the machine lacks is 0
///   I J K  of an arc: from its start to its centre, along X, Y, Z; else 0
///   R      radius of the tool in the spindle: that of the tool offset of its number, wear included
///   T      its number, 0: none yet
///   F      mm/min; 0 of a rapid; of a tool change the one before
///   A      degrees: direction in the XY plane from where the row before ended, of an arc that of
///   its
///          chord (geometry::heading_deg); 360 without way in the plane, 720 of a tool change
///
/// An arc in space is lines as in Post. What does not move, but the tool change, has no row.
class RowCsv : public motion::MotionSink {
 public:
  /// All must outlive the writer.
  RowCsv(const motion::AxisSetup& axes, const control::Memory& memory, base::OutputFile& file);
  void take(const motion::Motion& motion) override;

 private:
  static constexpr double kToolChange_deg = 720;
  using Xyz = std::array<double, 3>;

  void straight(std::string_view code, const base::TipPoint& to, const motion::Feed& feed);
  void arc(const motion::Arc& arc);
  void space_arc(const motion::SpaceArc& arc);
  void surface_move(const motion::SurfaceMove& move);
  void move(std::string_view code, const base::TipPoint& to, const Xyz& centre, double feed);
  void write(std::string_view code, const Xyz& to, const Xyz& centre, double feed, double heading);
  [[nodiscard]] Xyz xyz_of(const base::TipPoint& point) const;
  [[nodiscard]] double length_to(const base::TipPoint& to) const;
  [[nodiscard]] double tool_radius() const;

  const motion::AxisSetup& axes_;
  const control::Memory& memory_;
  base::OutputFile& file_;
  std::array<std::optional<base::Axis>, 3> xyz_;
  base::TipPoint at_;
  std::uint32_t line_ = 0;
  std::uint32_t tool_ = 0;
  double feed_ = 0;  // of the last move that was no rapid
  double speed_rpm_ = 0;
  std::string row_;
};

}  // namespace kerf::output
