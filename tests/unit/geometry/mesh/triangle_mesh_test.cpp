#include "geometry/mesh/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace kerf::mesh {
namespace {

/// The corner of a cube that a plane through its three neighbours cuts off, at `at`.
TriangleMesh tetrahedron(Vec3 at, double edge) {
  return {.points = {at, at + Vec3{edge, 0, 0}, at + Vec3{0, edge, 0}, at + Vec3{0, 0, edge}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(TriangleMesh, ATetrahedronHasASixthOfItsCube) {
  EXPECT_DOUBLE_EQ(volume_mm3(tetrahedron({0, 0, 0}, 3)), 4.5);
}

TEST(TriangleMesh, APartFarFromTheOriginLosesNoDigits) {
  EXPECT_DOUBLE_EQ(volume_mm3(tetrahedron({1e6, -1e6, 1e6}, 3)), 4.5);
}

TEST(TriangleMesh, TurnedInsideOutItIsNegative) {
  TriangleMesh mesh = tetrahedron({1, 2, 3}, 3);
  for (Triangle& one : mesh.triangles) std::swap(one[1], one[2]);
  EXPECT_DOUBLE_EQ(volume_mm3(mesh), -4.5);
}

TEST(TriangleMesh, ItsBoxHoldsEveryPoint) {
  const MeshBox box = box_of(tetrahedron({1, 2, 3}, 4));
  EXPECT_EQ(box.low, (Vec3{1, 2, 3}));
  EXPECT_EQ(box.high, (Vec3{5, 6, 7}));
}

TEST(TriangleMesh, WithoutPointsThereIsNoBoxAndNoVolume) {
  const MeshBox box = box_of({});
  EXPECT_GT(box.low.x, box.high.x);
  EXPECT_EQ(volume_mm3({}), 0);
}

}  // namespace
}  // namespace kerf::mesh
