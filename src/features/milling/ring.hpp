#pragma once

#include <optional>

#include "features/literal/loops.hpp"
#include "features/milling/level.hpp"

namespace kerf::features {

/// One way round a piece that stays, or round one that falls out: side milling.
struct Ring {
  contour::Contour loop{};              ///< of the tool's axis, closed
  Region sweep{};                       ///< by the loop alone, without what leads to it and away
  std::optional<contour::Vec2> lead{};  ///< where the tool came from or went to beside the loop
};

/// The ring that a level is: its rows go round once, and something inside stays that the tool does
/// not reach. Nothing: it is none. `loops`: those of its rows.
[[nodiscard]] std::optional<Ring> ring_of(const Recording& recording, const Level& level,
                                          const LoopsOfRows& loops);

}  // namespace kerf::features
