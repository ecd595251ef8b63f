#pragma once

#include <optional>

#include "features/milling/level.hpp"
#include "features/milling/material.hpp"
#include "features/milling/ring.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// A level with what it has done to the material.
struct ShapedLevel {
  Level level{};
  LoopsOfRows loops{};
  std::optional<Ring> ring{};
  Layer layer{};
  double open_mm = 0;     ///< of the outline, that lies on the border of the blank
  double outline_mm = 0;  ///< whole length of it
  int wall_chains = 0;    ///< closed parts of the outline between open ones
};

/// What a level removes of the material, which stays as it is. The level's radius becomes that of
/// a cone at the top of what it meets. Nothing: the allowance is over, and the level is as it was.
[[nodiscard]] std::optional<ShapedLevel> shaped(const Recording& recording,
                                                const Material& material, const ToolReach& reach,
                                                Level&& level, Allowance& allowance);

/// Their nominal contours are equal.
[[nodiscard]] bool are_one_shape(const Layer& a, const Layer& b);

/// Pieces of a region that touch each other in points at most.
[[nodiscard]] std::size_t outline_count(const Region& region);

/// Contours of a layer anew, from its region and rows: after another operation has widened it.
void tell_contours(const Recording& recording, const Material& material, double radius,
                   Layer& layer);

}  // namespace kerf::features
