#pragma once

#include <optional>
#include <vector>

#include "control/gcode/path/corner_rounding.hpp"
#include "control/gcode/path/move_rules.hpp"

namespace kerf::control {

/// A line of a drawing of which only the angle is known: it ends where the next line crosses it.
/// What its block says of it, and what stands behind it until then.
struct UnfinishedLine {
  double angle_deg = 0;  ///< in the plane ZX, from +Z, counterclockwise
  motion::Feed feed;
  base::BlockId block;
  base::Place place{};
  MoveRules rules;
  std::optional<CornerAtEnd> corner{};
  std::vector<motion::Motion> beside{};
  int idle_blocks = -1;  ///< behind its own
};

}  // namespace kerf::control
