#include "geometry/mesh/triangle_mesh.hpp"

#include <algorithm>

namespace kerf::mesh {

MeshBox box_of(const TriangleMesh& mesh) {
  if (mesh.points.empty()) return {};
  MeshBox box{mesh.points.front(), mesh.points.front()};
  for (const Vec3& p : mesh.points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

double volume_mm3(const TriangleMesh& mesh) {
  if (mesh.points.empty()) return 0;
  // From a corner of its own, so that a part far from the origin loses no digits.
  const Vec3 from = mesh.points.front();
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum += dot(mesh.points[t[0]] - from, cross(mesh.points[t[1]] - from, mesh.points[t[2]] - from));
  }
  return sum / 6;
}

}  // namespace kerf::mesh
