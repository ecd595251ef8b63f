#pragma once

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/edit/outline.hpp"

namespace kerf::features {

// A fillet or a chamfer in one corner, or in every corner of two lines. The edge that comes in has
// the next free number; a fillet where elements go on smoothly changes nothing. Corner k is where
// element k begins. What is refused has changed nothing.

[[nodiscard]] Editing<void> fillet(Outline& outline, const FilletCorner& wish);
[[nodiscard]] Editing<void> chamfer(Outline& outline, const ChamferCorner& wish);

}  // namespace kerf::features
