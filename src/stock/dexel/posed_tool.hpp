#pragma once

#include <optional>
#include <vector>

#include "stock/dexel/frame.hpp"
#include "stock/dexel/solid.hpp"
#include "stock/sweep/body.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock::dexel {

/// A body as a model has it.
struct Tool {
  Body body;
  std::vector<Solid> solids;
  std::vector<Solid> touching;  ///< shrunk by the touch tolerance
  double height = 0;
  double widest = 0;  ///< of all
  double widest_edge = 0;

  [[nodiscard]] static Tool of(const Body& body, double tolerance_mm);
};

/// A solid in a direction.
struct PosedSolid {
  Solid solid;
  Solid around;       ///< holds a block's dexels when its middle one is in
  Bounds reach;       ///< of the solid, from the tip
  double margin = 0;  ///< by which `around` is larger
  Bounds around_reach;
};

/// A tool in a direction.
struct PosedTool {
  const Tool* tool = nullptr;
  Frame frame;
  std::vector<PosedSolid> solids;
  std::vector<PosedSolid> touching;
  std::optional<PosedSolid> core;
  Bounds reach;

  /// `block_mm`: from the middle of a block to its corner.
  [[nodiscard]] static PosedTool of(const Tool& tool, Vec3 axis, double block_mm);
};

/// A box around a solid, from the tip.
[[nodiscard]] Bounds reach_of(const Solid& solid, const Frame& frame);
[[nodiscard]] Bounds both(const Bounds& a, const Bounds& b);
/// A box that moves by `way`.
[[nodiscard]] Bounds swept(const Bounds& box, Vec3 from, Vec3 way);

}  // namespace kerf::stock::dexel
