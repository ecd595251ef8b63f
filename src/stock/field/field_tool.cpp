#include "stock/field/field_tool.hpp"

#include <algorithm>

namespace kerf::stock::field {
namespace {

FieldTool::Part part_of(const Body& body, ToolPart which, double error_mm) {
  FieldTool::Part part;
  part.whole = LowerEnvelope(body.profile, which, error_mm);
  part.shrunk = part.whole.shrunk(body.touch_mm);
  for (const ProfileEdge& edge : body.profile.edges()) {
    if (edge.part == which) part.top = edge.to.z;
  }
  return part;
}

}  // namespace

FieldTool::FieldTool(const Body& body, double error_mm)
    : core_mm(body.core_mm),
      touch_mm(body.touch_mm),
      cuts(body.cuts),
      has_undercut(body.profile.has_undercut()),
      reach(body.profile.widest()),
      edge_reach(body.profile.widest(ToolPart::edge)) {
  for (std::size_t i = 0; i < kToolParts; ++i) {
    parts[i] = part_of(body, static_cast<ToolPart>(i), error_mm);
  }
}

}  // namespace kerf::stock::field
