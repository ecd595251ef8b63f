#pragma once

#include "stock/field/field_tool.hpp"
#include "stock/field/legs.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock::field {

/// A sweep made ready for the tiles that it comes to.
struct ReadySweep {
  ReadySweep(const Sweep& sweep, const FieldTool& body, double error_mm, StraightLeg::Begins begins)
      : legs(legs_of(sweep.way, error_mm, begins)),
        tool(&body),
        tip(bounds(sweep.way)),
        reached(reached_by_edges()),
        motion(sweep.motion),
        cuts(sweep.kind == SweepKind::cut && body.cuts) {}

  /// Whether a part of the tool may not meet material.
  [[nodiscard]] bool guards(ToolPart part) const { return !cuts || part != ToolPart::edge; }

  Legs legs;
  const FieldTool* tool;
  Bounds tip;      ///< of the tip's way
  Bounds reached;  ///< X and Y of the columns that its edges may lower
  std::uint32_t motion;
  bool cuts;  ///< its edges may meet material

 private:
  [[nodiscard]] Bounds reached_by_edges() const {
    if (const auto* const straight = std::get_if<StraightLeg>(&legs))
      return straight->reached(tool->edges());
    return around(tip, tool->edges().reach());
  }
};

}  // namespace kerf::stock::field
