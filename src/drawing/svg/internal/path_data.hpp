#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drawing/pen.hpp"

namespace kerf::drawing::svg {

/// Draws path data up to its end or its first mistake, as the standard asks, and says what the
/// mistake is and where. What goes nowhere at all leaves its points, for holes.
[[nodiscard]] std::optional<std::string> draw_path(std::string_view data, Canvas& canvas,
                                                   EntityId entity, const Affine& to_mm);

}  // namespace kerf::drawing::svg
