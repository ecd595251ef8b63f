#pragma once

#include <functional>
#include <string_view>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::output {

/// Takes the bytes of a file piece by piece.
using TakeBytes = std::function<void(std::string_view)>;

/// Binary STL: 80 bytes of header without a date, the number of triangles, 50 bytes each. mm.
/// Precondition: fewer than 2³² triangles.
void write_stl(const mesh::TriangleMesh& mesh, const TakeBytes& take);

}  // namespace kerf::output
