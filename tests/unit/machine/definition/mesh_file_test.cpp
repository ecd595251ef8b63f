#include "machine/definition/mesh_file.hpp"

#include <gtest/gtest.h>

#include "geometry/mesh/meshes.hpp"

namespace kerf::machine {
namespace {

using mesh::test::binary_stl;
using mesh::test::block;
using mesh::test::text_stl;

constexpr std::size_t kMemory = 1 << 20;

TEST(MeshFile, BinaryAndTextInMillimetresAndInches) {
  const mesh::TriangleMesh cube = block({0, 0, 0}, {2, 2, 2});
  for (const std::string& bytes : {binary_stl(cube), text_stl(cube)}) {
    EXPECT_DOUBLE_EQ(mesh_of(bytes, "cube.stl", MeshUnit::mm, kMemory)->volume_mm3, 8);
    EXPECT_DOUBLE_EQ(mesh_of(bytes, "cube.stl", MeshUnit::inch, kMemory)->volume_mm3,
                     8 * 25.4 * 25.4 * 25.4);
  }
}

TEST(MeshFile, FailuresNameTheFile) {
  mesh::TriangleMesh cube = block({0, 0, 0}, {2, 2, 2});
  cube.triangles.pop_back();
  const auto open = mesh_of(binary_stl(cube), "holed.stl", MeshUnit::mm, kMemory);
  EXPECT_EQ(open.error().kind, base::Failure::Kind::input);
  EXPECT_EQ(open.error().message,
            "holed.stl: the mesh is not closed: 3 open edges, the first from X2 Y2 Z0 to X2 Y0 Z2");
  EXPECT_EQ(mesh_of("", "none.stl", MeshUnit::mm, kMemory).error().message,
            "none.stl: the file is too short for an STL");
  EXPECT_EQ(read_mesh("/no/such.stl", MeshUnit::mm, kMemory).error().message,
            "/no/such.stl: No such file or directory");
}

TEST(MeshFile, TheMemoryBoundsItsTriangles) {
  const std::string bytes = binary_stl(block({0, 0, 0}, {2, 2, 2}));
  EXPECT_EQ(mesh_of(bytes, "cube.stl", MeshUnit::mm, 900).error().message,
            "cube.stl: 12 triangles are more than the 11 that there is memory for");
}

}  // namespace
}  // namespace kerf::machine
