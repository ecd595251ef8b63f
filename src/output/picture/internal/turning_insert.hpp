#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec2.hpp"
#include "output/picture/internal/tool_way.hpp"
#include "output/picture/internal/turning_recorder.hpp"

namespace kerf::output::plot {

/// The cutting part of a turning tool in the (z, x) plane, mm from the tip that programs move. Nose
/// and direction are those of the offset; what the control's tables do not have is assumed from how
/// the tool moves.
struct TurningInsert {
  enum class Kind : std::uint8_t {
    rhomb,   ///< turns, faces, bores
    thread,  ///< 60° between flanks that stand on the axis
    blade,   ///< goes straight into the part
    drill,   ///< on the axis
    driven   ///< turns itself, while the spindle is an axis
  };
  Kind kind = Kind::rhomb;
  geometry::Vec2 tip{-1, -1};  ///< direction from the nose to the tip: -1, 0 or 1 each
  bool tip_known = false;
  double nose_mm = 0;
  double corner_deg = 80;  ///< of a rhomb
  double width_mm = 3;     ///< of a blade, assumed; of a drill, 0: not known
  bool inside = false;     ///< it works in a bore, away from the axis

  /// The nose's centre.
  [[nodiscard]] geometry::Vec2 nose() const {
    return -nose_mm * (tip_known ? tip : geometry::Vec2{});
  }
  /// What a blade covers along z.
  [[nodiscard]] double left_mm() const { return (-tip.u - 1) / 2 * width_mm; }
  /// Its outline, with edges of about this length.
  [[nodiscard]] std::vector<geometry::Vec2> outline(double edge_mm) const;
  /// For people: "80° insert, R 0.8, tip 3".
  [[nodiscard]] std::string words() const;

  int tip_number = 0;
};

/// Of a tool that moves so. `middle_mm`: half way along what is turned; a tool that only faces, in
/// front of it, is no blade.
[[nodiscard]] TurningInsert insert_of(const TurningTool& tool, const ToolWay& way, bool threads,
                                      double middle_mm);

}  // namespace kerf::output::plot
