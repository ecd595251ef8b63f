#include "stock/dexel/posed_tool.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock::dexel {
namespace {

PosedSolid posed(const Solid& solid, const Frame& frame, double block_mm) {
  const Solid around = grown(solid, block_mm);
  return {solid, around, reach_of(solid, frame), block_mm, reach_of(around, frame)};
}

std::vector<PosedSolid> posed(const std::vector<Solid>& solids, const Frame& frame,
                              double block_mm) {
  std::vector<PosedSolid> all;
  for (const Solid& solid : solids) all.push_back(posed(solid, frame, block_mm));
  return all;
}

/// Of the solid along one axis of the stock, whose component of the tool's axis is `up`.
void extend(const Solid& solid, double up, double& low, double& high) {
  const double across = solid.widest() * std::sqrt(std::max(0.0, 1 - up * up));
  low = std::min(up * solid.low, up * solid.high) - across;
  high = std::max(up * solid.low, up * solid.high) + across;
}

}  // namespace

Tool Tool::of(const Body& body, double tolerance_mm) {
  Tool tool{body,
            solids_of(body.profile, tolerance_mm),
            {},
            body.profile.height(),
            body.profile.widest(),
            body.profile.widest(ToolPart::edge)};
  for (const Solid& solid : tool.solids) {
    if (auto touching = shrunk_at_faces(solid, body.touch_mm)) tool.touching.push_back(*touching);
  }
  return tool;
}

PosedTool PosedTool::of(const Tool& tool, Vec3 axis, double block_mm) {
  PosedTool posed_tool;
  posed_tool.tool = &tool;
  posed_tool.frame = Frame::of(axis);
  posed_tool.solids = posed(tool.solids, posed_tool.frame, block_mm);
  posed_tool.touching = posed(tool.touching, posed_tool.frame, block_mm);
  if (tool.body.core_mm > 0) {
    posed_tool.core = posed(Solid::cone(tool.body.core_mm, 0, 0, 0), posed_tool.frame, block_mm);
  }
  for (const PosedSolid& each : posed_tool.solids) {
    posed_tool.reach = both(posed_tool.reach, each.reach);
  }
  return posed_tool;
}

Bounds reach_of(const Solid& solid, const Frame& frame) {
  Bounds box;
  extend(solid, frame.up.x, box.low.x, box.high.x);
  extend(solid, frame.up.y, box.low.y, box.high.y);
  extend(solid, frame.up.z, box.low.z, box.high.z);
  return box;
}

Bounds both(const Bounds& a, const Bounds& b) {
  return {
      {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
      {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

Bounds swept(const Bounds& box, Vec3 from, Vec3 way) {
  const Bounds first{box.low + from, box.high + from};
  return both(first, {first.low + way, first.high + way});
}

}  // namespace kerf::stock::dexel
