#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "drawing/drawing.hpp"
#include "process/machine_facts.hpp"
#include "process/order.hpp"
#include "process/passes.hpp"
#include "process/recipe.hpp"
#include "process/settled.hpp"
#include "process/sheet.hpp"

namespace kerf::process {

/// An operation with what it makes, in the order in which it is made.
struct PlannedOperation {
  std::size_t index = 0;                     ///< in the recipe
  std::uint32_t copy = drawing::kEveryCopy;  ///< that it is made for
  Operation operation;
  Settled settled;
  AlongRules rules;
  std::vector<Pass> passes;
  std::vector<Turn> turns;  ///< their items are passes
  std::size_t contours = 0;
  std::size_t scan_lines = 0;
  std::vector<RasterFacts> rasters;
  std::optional<double> j_mm2;  ///< of heat: what the surface gets
};

/// What is made of a drawing on a machine: everything but the motions, which PlanReader makes.
struct Plan {
  MachineFacts machine;
  std::vector<PlannedOperation> operations;
  std::vector<drawing::Affine> copies;  ///< of the array, in the order in which they are made
  Vec2 origin;  ///< where the way begins: the work origin, of a linkage where its joints are 0
  End end;
  Wrap wrap;
  double tolerance_mm = 0.01;
  double travel_order_mm = 0;    ///< ways between passes, as they are made
  double travel_file_mm = 0;     ///< in the order of the drawing
  double travel_nearest_mm = 0;  ///< going to the nearest next one
  std::vector<drawing::Finding> findings;
  std::vector<std::string> assumed;
};

/// Plans the enabled operations of a recipe; materials have been filled in.
[[nodiscard]] Plan plan_of(const drawing::Drawing& drawing, const Sheet& sheet,
                           const Recipe& recipe, const MachineFacts& machine);

}  // namespace kerf::process
