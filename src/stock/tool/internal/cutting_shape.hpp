#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "stock/tool/profile.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::stock {

/// The outline of what a tool cuts with, from the tip upwards.
struct CuttingShape {
  std::vector<ProfileEdge> edges;
  /// It ends where the edges do; else its last radius goes on as long as the flutes.
  bool ends = false;
  /// Of what stands on a part that ends, where somebody has said it.
  std::optional<double> neck_mm{};
};
using ShapeOutcome = tl::expected<CuttingShape, std::string>;

// A function a row of stock.md §1.2. Precondition of each: the measures that the kind needs are
// there, each in its own range.
[[nodiscard]] ShapeOutcome flat_shape(const Tool& tool);  ///< also bull, and the ring of boring
[[nodiscard]] ShapeOutcome ball_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome cone_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome drill_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome centre_drill_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome reamer_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome tap_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome face_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome disc_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome dovetail_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome lollipop_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome thread_mill_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome form_shape(const Tool& tool);
[[nodiscard]] ShapeOutcome probe_shape(const Tool& tool);

}  // namespace kerf::stock
