#pragma once

#include <cstdint>
#include <span>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh {

/// Of some corners those that are within `distance_mm` of each other, or joined by others that are,
/// become the one with the smallest number. How many are now another one.
std::uint64_t join_near(TriangleMesh& mesh, std::span<const std::uint32_t> corners,
                        double distance_mm);

}  // namespace kerf::mesh
