#pragma once

#include "geometry/contour/region.hpp"
#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// A region of the half plane (u = Z, v = ρ >= 0) turned about Z: as TurnedPart holds it, so X is
/// along its radius at the angle 0. No point of it is farther from the true surface than
/// `tolerance_mm` > 0, and it holds the same volume: chords go as much beyond that as they stay
/// behind. Edges keep their owners.
[[nodiscard]] Surface turned(const contour::Region& region, double tolerance_mm);

/// The owner of the faces that show the inside.
inline constexpr std::uint32_t kSection = 0xffff'ffff;

/// What of it lies at the angles from `begin_rad` on, `sweep_rad` in (0, 2 pi) of them, closed by
/// two sections: to look into.
[[nodiscard]] Surface turned_open(const contour::Region& region, double tolerance_mm,
                                  double begin_rad, double sweep_rad);

}  // namespace kerf::stock::surface
