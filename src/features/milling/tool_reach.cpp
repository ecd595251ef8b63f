#include "features/milling/tool_reach.hpp"

#include <algorithm>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::features {

using stock::Measure;
using stock::ToolKind;

double ToolReach::at_depth(double depth) const {
  if (!is_cone()) return radius;
  return std::min(radius, tip_radius + slope * std::max(depth, 0.0));
}

ToolReach reach_of(const stock::Tool& tool) {
  ToolReach reach{.radius = tool.value(Measure::diameter).value_or(0) / 2};
  if (!is_conical(tool)) return reach;
  reach.slope = math::tan(geometry::radians(tool.value(Measure::angle).value_or(90)) / 2);
  reach.tip_radius = tool.value(Measure::tip_diameter).value_or(0) / 2;
  return reach;
}

bool is_conical(const stock::Tool& tool) {
  return tool.kind == ToolKind::chamfer || tool.kind == ToolKind::engrave;
}

bool is_engraver(const stock::Tool& tool) {
  return tool.kind == ToolKind::engrave || tool.type == "v";
}

bool is_round_ended(const stock::Tool& tool) {
  return tool.kind == ToolKind::ball || tool.kind == ToolKind::bull;
}

}  // namespace kerf::features
