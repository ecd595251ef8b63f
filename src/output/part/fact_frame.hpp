#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "output/part/part_frame.hpp"

namespace kerf::output {

// What is told of places besides where they are: parts of a frame of PartKind::facts, of which each
// is named by its tile, or by its number among the loops.

/// How far PartPlaces are from a design, mm; what is not known is none. The step of a part is its
/// largest deviation through 32,767, so each is right to half of that.
[[nodiscard]] std::string deviation_part(stock::surface::Place part,
                                         std::span<const std::optional<float>> deviations_mm);
/// Who cut what begins at them.
[[nodiscard]] std::string owner_part(stock::surface::Place part,
                                     std::span<const std::uint16_t> owners);

}  // namespace kerf::output
