#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::stock::surface {

/// The surface of what is left, frame of the stock, mm. Closed: every edge belongs to exactly two
/// triangles, which run along it in opposite directions; oriented outwards; no two points stand at
/// one place, also not as float32; no triangle is without area. Plain value.
struct Surface {
  mesh::TriangleMesh mesh;
  /// The motion that cut each triangle; 0: it was the stock's.
  std::vector<std::uint32_t> owners;
  /// Of each point the motion of one of the faces that meet there, the one that most of them have.
  std::vector<std::uint32_t> point_owners;
};

}  // namespace kerf::stock::surface
