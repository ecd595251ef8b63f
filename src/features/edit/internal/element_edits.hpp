#pragma once

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/edit/outline.hpp"

namespace kerf::features {

// Edits of one element or two. Where an end of an element moves, an end that was joined to it
// follows: of a line as it is, of an arc that sweeps the same angle as before.

[[nodiscard]] Editing<void> modify(Outline& outline, const ModifyLine& wish);
[[nodiscard]] Editing<void> modify(Outline& outline, const ModifyArc& wish);
/// The ends that are joined are those by which they are neighbours, or else the nearest ones.
[[nodiscard]] Editing<void> join(Outline& outline, const JoinElements& wish);
[[nodiscard]] Editing<void> remove(Outline& outline, const DeleteElement& wish);

}  // namespace kerf::features
