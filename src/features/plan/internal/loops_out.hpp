#pragma once

#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

/// All rows that ran within these lines become blocks of their own, with what is cut anew among
/// them.
void write_out(EditScene& scene, Span lines);
/// Likewise all rows of the run of a call that made a row of it.
[[nodiscard]] Done write_out_call(EditScene& scene, const Call& call, std::uint32_t row);
/// Features that the same blocks cut in other calls change with this one.
void free_what_shares(EditScene& scene, std::size_t feature);

}  // namespace kerf::features
