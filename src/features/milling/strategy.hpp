#pragma once

#include <optional>

#include "features/milling/shaped_level.hpp"

namespace kerf::features {

/// How a level was cleared, and how far its passes lie beside each other.
struct Clearing {
  Strategy strategy = Strategy::single;
  std::optional<double> stepover{};
};
[[nodiscard]] Clearing clearing_of(const Recording& recording, const ShapedLevel& shaped);

/// By the lengths of the first and the last loop.
[[nodiscard]] Order order_of(const std::vector<Loop>& loops);

/// On which side of the feed the walls of a layer lie. `walls`: the contours that count.
[[nodiscard]] Milling milling_of(const Recording& recording,
                                 const std::vector<const contour::Contour*>& outlines,
                                 const std::vector<const contour::Contour*>& islands);

}  // namespace kerf::features
