#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

#include "base/diagnostic_code.hpp"
#include "geometry/vec2.hpp"

namespace kerf::features {

/// Why a layer cannot be cut anew: a code of edits, and its sentence.
struct CannotCut {
  base::Code code{};
  std::string sentence{};
};

[[nodiscard]] tl::unexpected<CannotCut> cannot_edit(std::string why);
[[nodiscard]] tl::unexpected<CannotCut> does_not_fit(std::uint32_t tool);
/// What the tool could reach, and nothing cuts.
[[nodiscard]] CannotCut left_uncut(double area_mm2, geometry::Vec2 at);

}  // namespace kerf::features
