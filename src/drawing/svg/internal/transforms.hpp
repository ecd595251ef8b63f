#pragma once

#include <optional>
#include <string_view>

#include "drawing/affine.hpp"

namespace kerf::drawing::svg {

/// A list of transforms, of which the last one is done first. None: there is a mistake in it, for
/// which the standard says that the element has no transform. Angles in degrees, also with "deg";
/// lengths also with "px".
[[nodiscard]] std::optional<Affine> transform_of(std::string_view text);

}  // namespace kerf::drawing::svg
