#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh {

/// The surface of a solid: closed, every edge passed as often in the one direction as in the other,
/// outwards oriented on the whole (its volume is positive). Shells may lie inside of others, touch
/// and overlap; triangles may be without area, if their corners are three.
struct SolidMesh {
  TriangleMesh mesh;
  double volume_mm3 = 0;  ///< > 0; what shells share is counted for each of them
  /// What was not taken as it was, in sentences: triangles left out, corners joined.
  std::vector<std::string> changes{};
};

/// Corners that are not further apart than this are one where edges would be open otherwise.
inline constexpr double kJoined_mm = 1e-6;

/// Makes a solid of triangles in any state: leaves out those with fewer than three corners and,
/// where edges are open, those that are there twice; joins corners by kJoined_mm; turns all if they
/// look inwards.
/// Failure (input): no triangles, open edges, triangles that look to opposite sides, nothing
/// enclosed; the message is a sentence without the name of a file.
[[nodiscard]] base::Outcome<SolidMesh> solid_of(TriangleMesh mesh);

}  // namespace kerf::mesh
