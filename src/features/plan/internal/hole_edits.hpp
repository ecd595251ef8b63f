#pragma once

#include "features/plan/internal/edit_scene.hpp"
#include "features/plan/internal/feature_wish.hpp"

namespace kerf::features {

/// What one edit adds to what its hole shall become. Origins are checked already.
[[nodiscard]] Done wish_of_hole(const EditScene& scene, const Edit& edit, std::size_t hole,
                                HoleWish& wish);

/// Makes the rows of holes what is wished, and then those of all that go.
[[nodiscard]] Done make_holes(EditScene& scene, std::map<std::size_t, HoleWish>& wishes);

}  // namespace kerf::features
