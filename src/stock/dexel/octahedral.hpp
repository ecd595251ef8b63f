#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec3.hpp"

namespace kerf::stock::dexel {

/// A direction in two bytes: the octahedron |x| + |y| + |z| = 1 unfolded to a square. Within 1.0
/// degree; the six directions of the axes are exact.
using Octahedral = std::array<std::int8_t, 2>;

/// Precondition: not the zero vector. Any length.
[[nodiscard]] Octahedral octahedral(geometry::Vec3 direction);
/// Unit.
[[nodiscard]] geometry::Vec3 direction(Octahedral packed);

}  // namespace kerf::stock::dexel
