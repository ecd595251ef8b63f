#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vec3.hpp"

namespace kerf::mesh {

using geometry::Vec3;

/// Numbers of three corners, anticlockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// A surface of triangles that share their corners, mm. Plain value; what is required of it
/// (closed, oriented, without triangles that are no area) is said by whoever takes one.
struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// The box around its points; low > high: there are none.
struct MeshBox {
  Vec3 low{0, 0, 0};
  Vec3 high{-1, -1, -1};
};
[[nodiscard]] MeshBox box_of(const TriangleMesh& mesh);

/// What a closed, outwards oriented mesh encloses, mm³; the origin may lie anywhere.
[[nodiscard]] double volume_mm3(const TriangleMesh& mesh);

}  // namespace kerf::mesh
