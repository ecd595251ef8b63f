#pragma once

#include <array>

#include "stock/field/lower_envelope.hpp"
#include "stock/sweep/body.hpp"

namespace kerf::stock::field {

/// A body as a height field needs it.
struct FieldTool {
  /// A part seen from below.
  struct Part {
    LowerEnvelope whole;
    LowerEnvelope shrunk;  ///< by the touch tolerance
    double top = 0;        ///< where it ends, over the tip
  };

  FieldTool(const Body& body, double error_mm);

  [[nodiscard]] const Part& part(ToolPart which) const { return parts[index(which)]; }
  [[nodiscard]] const LowerEnvelope& edges() const { return part(ToolPart::edge).whole; }

  std::array<Part, kToolParts> parts;
  double core_mm = 0;
  double touch_mm = 0;
  bool cuts = true;
  bool has_undercut = false;
  double reach = 0;       ///< of the whole body, 0 of nothing
  double edge_reach = 0;  ///< of its edges
};

}  // namespace kerf::stock::field
