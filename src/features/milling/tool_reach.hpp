#pragma once

#include "stock/tool/tool.hpp"

namespace kerf::features {

/// How far a mill reaches round its axis, mm.
struct ToolReach {
  double radius = 0;
  double slope = 0;       ///< of a cone: radius per height above its tip
  double tip_radius = 0;  ///< of a cone

  /// Of a cone, which cuts as wide as it is deep; of all else its radius.
  [[nodiscard]] double at_depth(double depth) const;
  [[nodiscard]] bool is_cone() const { return slope > 0; }
};

[[nodiscard]] ToolReach reach_of(const stock::Tool& tool);

/// A tool for engraving: v, engrave, taper.
[[nodiscard]] bool is_engraver(const stock::Tool& tool);
/// A cone that breaks edges or spots.
[[nodiscard]] bool is_conical(const stock::Tool& tool);
[[nodiscard]] bool is_round_ended(const stock::Tool& tool);

}  // namespace kerf::features
