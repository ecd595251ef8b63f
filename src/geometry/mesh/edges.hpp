#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh {

/// What stands in the way of a mesh being the surface of a solid. In one that is closed and
/// oriented every edge is passed as often in the one direction as in the other.
struct EdgeFaults {
  std::uint64_t open = 0;                ///< edges with an odd number of triangles
  std::uint64_t turned = 0;              ///< edges whose triangles do not look to the same side
  std::array<std::uint32_t, 2> first{};  ///< corners of the first of them
  std::vector<std::uint32_t> corners{};  ///< of all of them, rising

  [[nodiscard]] bool is_none() const { return open == 0 && turned == 0; }
};

/// n log n at worst, 12 bytes a triangle and 4 a point beside the mesh. Precondition: fewer than
/// 2^31 points.
[[nodiscard]] EdgeFaults edge_faults(const TriangleMesh& mesh);

}  // namespace kerf::mesh
