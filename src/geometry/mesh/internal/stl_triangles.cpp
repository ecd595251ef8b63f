#include "geometry/mesh/internal/stl_triangles.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::mesh {

using geometry::Vec3;

void StlTriangles::reserve(std::size_t triangles) {
  triangles_.reserve(triangles);
  corners_.reserve(triangles / 2 + 2);  // what a closed surface of triangles has
}

Wrong StlTriangles::add_corner(Vec3 corner) {
  corner = settings_.mm_per_unit * corner;
  for (const double value : {corner.x, corner.y, corner.z}) {
    if (!std::isfinite(value)) return "a corner has a coordinate that is no number";
    if (std::fabs(value) > StlReader::kFarthest_mm)
      return "a corner lies at " + base::number_text(value) + " mm, beyond " +
             base::number_text(StlReader::kFarthest_mm) + " mm";
  }
  open_[corner_++] = corners_.number_of(corner);
  if (corner_ < 3) return std::nullopt;
  if (triangles_.size() == settings_.most_triangles)
    return "more than " + std::to_string(settings_.most_triangles) + " triangles";
  triangles_.push_back(open_);
  corner_ = 0;
  return std::nullopt;
}

}  // namespace kerf::mesh
