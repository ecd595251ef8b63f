#pragma once

#include <tl/expected.hpp>

#include "features/rewrite/clearing.hpp"
#include "features/rewrite/regenerate.hpp"

namespace kerf::features {

/// The radius of the tool that cut a layer; 0: nobody says.
[[nodiscard]] double radius_of_tool(const Recording& recording, const NewLayer& wanted, Span visit);
[[nodiscard]] tl::unexpected<CannotCut> unknown_tool();

/// No arc of the walls is one that the tool would have to go round on its inside and cannot.
[[nodiscard]] tl::expected<void, CannotCut> check_corners(const Clearing& clearing);

/// Likewise of what stands, where the tool goes round it outside.
[[nodiscard]] tl::expected<void, CannotCut> check_hollows(const Clearing& clearing);

}  // namespace kerf::features
