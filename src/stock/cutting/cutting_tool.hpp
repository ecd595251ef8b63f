#pragma once

#include <cstdint>
#include <optional>

#include "stock/sweep/body.hpp"
#include "stock/sweep/way.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::stock {

/// A tool as a run cuts with it.
struct CuttingTool {
  Tool tool;
  Body body;  ///< made of it once
  /// Of a lathe a tool that turns itself: from its tip up, in the machine. None: it stands, or it
  /// is that of a mill, along Z.
  std::optional<Vec3> driven{};

  /// From its tip up, in the machine.
  [[nodiscard]] Vec3 axis() const { return driven.value_or(Vec3{0, 0, 1}); }

  [[nodiscard]] std::uint32_t number() const { return static_cast<std::uint32_t>(tool.number); }
  [[nodiscard]] bool is_probe() const { return tool.kind == ToolKind::probe; }
  [[nodiscard]] bool is_axial() const { return row_of(tool.kind).is_axial; }
  /// Somebody has said its outline: what collides with it is no guess. What the offset memory
  /// knows is the radius of a mill, and of an insert its nose alone.
  [[nodiscard]] bool knows_shape() const {
    return tool.source != ToolSource::assumed &&
           (tool.source != ToolSource::offset || !tool.is_insert());
  }
  /// Somebody has said which way it must turn.
  [[nodiscard]] bool knows_hand() const {
    return tool.source == ToolSource::file || tool.source == ToolSource::machine;
  }
  [[nodiscard]] double diameter_mm() const { return 2 * body.profile.widest(ToolPart::edge); }
};

/// Of an insert the body has no profile: it cuts nothing where the spindle turns the tool.
/// Precondition: objection(tool) is empty.
[[nodiscard]] CuttingTool cutting_tool(const Tool& tool, double touch_mm);

/// The tools of a run.
class ToolRack {
 public:
  virtual ~ToolRack() = default;
  /// Every number has a tool; the reference stays good.
  [[nodiscard]] virtual const CuttingTool& tool(std::uint32_t number) = 0;
};

}  // namespace kerf::stock
