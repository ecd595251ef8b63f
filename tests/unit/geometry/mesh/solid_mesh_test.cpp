#include "geometry/mesh/solid_mesh.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh/edges.hpp"
#include "geometry/mesh/meshes.hpp"

namespace kerf::mesh {
namespace {

using test::block;
using test::both;
using test::turned;

TriangleMesh cube() { return block({0, 0, 0}, {10, 10, 10}); }

std::string failure(const TriangleMesh& mesh) {
  const auto solid = solid_of(mesh);
  return solid ? "no failure" : solid.error().message;
}

TEST(SolidMesh, ASoundOneStaysAsItIs) {
  const auto solid = solid_of(cube());
  ASSERT_TRUE(solid);
  EXPECT_DOUBLE_EQ(solid->volume_mm3, 1000);
  EXPECT_TRUE(solid->changes.empty());
  EXPECT_EQ(solid->mesh.triangles, cube().triangles);
}

TEST(SolidMesh, EachTriangleThatIsMissingOpensItsEdges) {
  for (std::size_t i = 0; i < 12; ++i) {
    TriangleMesh mesh = cube();
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(edge_faults(mesh).open, 3U);
    EXPECT_EQ(edge_faults(mesh).turned, 0U);
    EXPECT_NE(failure(mesh).find("the mesh is not closed: 3 open edges, the first from X"),
              std::string::npos);
  }
}

TEST(SolidMesh, AFaceThatIsMissingHasFourOpenEdges) {
  TriangleMesh mesh = cube();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  EXPECT_EQ(failure(mesh),
            "the mesh is not closed: 4 open edges, the first from X0 Y0 Z0 to X10 Y0 Z0");
}

TEST(SolidMesh, ATriangleThatLooksInwardsIsNotTakenForAHole) {
  TriangleMesh mesh = cube();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  EXPECT_EQ(failure(mesh),
            "the mesh is not oriented: 3 edges between triangles that look to opposite sides, the "
            "first from X0 Y0 Z0 to X10 Y0 Z0");
}

TEST(SolidMesh, OneThatLooksInwardsAltogetherIsTurned) {
  const auto solid = solid_of(turned(cube()));
  ASSERT_TRUE(solid);
  EXPECT_DOUBLE_EQ(solid->volume_mm3, 1000);
  EXPECT_DOUBLE_EQ(volume_mm3(solid->mesh), 1000);
  EXPECT_EQ(solid->changes, std::vector<std::string>{"all triangles turned: they looked inwards"});
}

TEST(SolidMesh, ACavityLooksInwards) {
  const auto solid = solid_of(both(cube(), turned(block({2, 2, 2}, {4, 4, 4}))));
  ASSERT_TRUE(solid);
  EXPECT_DOUBLE_EQ(solid->volume_mm3, 992);
}

TEST(SolidMesh, TrianglesWithoutCornersAreLeftOut) {
  TriangleMesh mesh = cube();
  mesh.triangles.insert(mesh.triangles.begin() + 3, Triangle{1, 1, 2});
  mesh.points.push_back({5, 5, 5});
  mesh.triangles.push_back({8, 8, 8});
  const auto solid = solid_of(mesh);
  ASSERT_TRUE(solid);
  EXPECT_EQ(solid->mesh.triangles, cube().triangles);
  EXPECT_EQ(solid->mesh.points.size(), 8U);
  EXPECT_EQ(solid->changes, std::vector<std::string>{"2 triangles without three corners left out"});
}

TEST(SolidMesh, TrianglesThatAreThereTwiceAreLeftOut) {
  TriangleMesh mesh = cube();
  mesh.triangles.push_back({2, 1, 0});  // the first, begun elsewhere
  mesh.triangles.push_back({1, 2, 3});
  const auto solid = solid_of(mesh);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(solid->mesh.triangles, cube().triangles);
  EXPECT_EQ(solid->changes, std::vector<std::string>{"2 triangles that were there twice left out"});
}

/// Two solids on the same base: it is there twice, and neither is closed without it.
TEST(SolidMesh, ATriangleOfTwoShellsStays) {
  const TriangleMesh mesh{
      .points = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 1}, {0, 0, 2}},
      .triangles = {
          {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}, {0, 1, 4}, {0, 4, 2}, {1, 2, 4}}};
  const auto solid = solid_of(mesh);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(solid->mesh.triangles.size(), 8U);
}

/// A cube of which every triangle has corners of its own, each off by less than the tolerance.
TEST(SolidMesh, CornersThatAreNearlyTheSameAreJoined) {
  TriangleMesh mesh;
  double off = 1e-7;
  const TriangleMesh sound = cube();
  for (const Triangle& t : sound.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const std::uint32_t corner : t) {
      mesh.points.push_back(sound.points[corner] + Vec3{off, -off, off / 2});
      off = -off;
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const auto solid = solid_of(mesh);
  ASSERT_TRUE(solid) << solid.error().message;
  EXPECT_EQ(solid->mesh.points.size(), 8U);
  EXPECT_NEAR(solid->volume_mm3, 1000, 1e-3);
  EXPECT_EQ(solid->changes,
            std::vector<std::string>{"28 corners joined with another within 1e-6 mm"});
  mesh.points[4].x += 2e-5;
  EXPECT_NE(failure(mesh).find("open edge"), std::string::npos);
}

TEST(SolidMesh, WhatEnclosesNothingIsNone) {
  EXPECT_EQ(failure({}), "there are no triangles");
  EXPECT_EQ(
      failure({.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}, {0, 2, 1}}}),
      "the mesh encloses nothing");
  EXPECT_EQ(failure(both(cube(), turned(cube()))), "the mesh encloses nothing");
}

}  // namespace
}  // namespace kerf::mesh
