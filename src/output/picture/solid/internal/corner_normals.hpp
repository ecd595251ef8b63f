#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::output::plot {

/// Normals for shading: at a corner of a triangle the mean of the faces that meet there, by their
/// area, without those that turn away from it by more than 35 degrees. So round faces look round
/// and edges stay edges.
class CornerNormals {
 public:
  /// The mesh outlives it.
  explicit CornerNormals(const mesh::TriangleMesh& mesh);

  /// Unit; of a triangle without area whatever.
  [[nodiscard]] std::array<geometry::Vec3, 3> of(std::size_t triangle) const;

 private:
  const mesh::TriangleMesh& mesh_;
  std::vector<std::uint32_t> first_;  // of each point, in around_
  std::vector<std::uint32_t> around_;
  std::vector<std::array<float, 3>> faces_;  // normals, twice the area long
};

}  // namespace kerf::output::plot
