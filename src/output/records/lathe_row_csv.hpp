#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/output_file.hpp"
#include "control/core/memory.hpp"
#include "geometry/vec2.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/motion.hpp"

namespace kerf::output {

/// Writes motions of a lathe as the canonical rows of feature recognition, CSV:
/// `line,G,X,Z,I,K,R,T,F,A`, a row for each move and each tool change.
///
///   line  source line
///   G     0 rapid, 1 line, 2 arc clockwise, 3 counterclockwise, 31 probing move, 32 thread; T
///   X Z   where it ends, as records of motions have it: X is a diameter
///   I K   of an arc: from its start to its centre along X and Z, mm; else 0
///   R     radius of the nose: geometry and wear of the offset that T has brought
///   T     number of the tool, 0: none yet
///   F     as the program counts it: mm/rev or mm/min, of a thread its lead; 0 of a rapid; of a
///   tool
///         change the one before
///   A     degrees by which the way turns where the row begins, counterclockwise in (z, x), in
///         [0, 360): from the direction in which the row before came to the one in which this row
///         leaves. 360: one of the two has no way in the plane, or a tool change lies between; 720
///         of a tool change
///
/// A move on a surface is lines to the ends of its curves. What does not move, but the tool change,
/// has no row.
class LatheRowCsv : public motion::MotionSink {
 public:
  /// Precondition: the machine is a lathe with X and Z. All must outlive the writer.
  LatheRowCsv(const machine::MachineDefinition& machine, const control::Memory& memory,
              base::OutputFile& file);
  void take(const motion::Motion& motion) override;

 private:
  /// A move in the (z, x) plane, mm: its end, and the directions in which it begins and ends; no
  /// way, no direction.
  struct Move {
    std::string_view code;
    base::TipPoint to;
    geometry::Vec2 leaves, arrives;
    geometry::Vec2 to_centre{};
  };

  void act(const motion::Rapid& rapid) { straight("0", rapid.to); }
  void act(const motion::Line& line);
  void act(const motion::Arc& arc);
  void act(const motion::SurfaceMove& move);
  void act(const motion::Probe& probe);
  void act(const motion::Thread& thread);
  void act(const motion::ToolChange& change);
  void straight(std::string_view code, const base::TipPoint& to);
  void cut(std::string_view code, const base::TipPoint& to, double feed);
  void write(const Move& move, double feed, double turn_deg);
  [[nodiscard]] double turn_deg(geometry::Vec2 leaves) const;
  [[nodiscard]] geometry::Vec2 zx(const base::TipPoint& point) const {
    return {point[z_], point[x_]};
  }
  [[nodiscard]] double nose_radius() const;

  const machine::MachineDefinition& machine_;
  const control::Memory& memory_;
  base::OutputFile& file_;
  base::Axis x_, z_;
  base::TipPoint at_;
  geometry::Vec2 came_;  // direction in which the last row arrived
  std::uint32_t line_ = 0;
  std::uint32_t tool_ = 0;
  std::uint32_t offset_ = 0;
  double feed_ = 0;  // of the last cut
  std::string row_;
};

}  // namespace kerf::output
