#include "geometry/mesh/stl_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/mesh/meshes.hpp"

namespace kerf::mesh {
namespace {

using test::binary_stl;
using test::block;
using test::text_stl;

constexpr std::size_t kMany = 1000;

base::Outcome<TriangleMesh> read(const std::string& bytes, std::size_t piece = 1 << 20,
                                 double mm_per_unit = 1, std::size_t most = kMany) {
  StlReader reader({.size = bytes.size(), .mm_per_unit = mm_per_unit, .most_triangles = most});
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    if (!reader.take(std::string_view(bytes).substr(at, piece))) break;
  }
  return reader.finish();
}

std::string failure(const std::string& bytes, std::size_t most = kMany) {
  const auto mesh = read(bytes, 1 << 20, 1, most);
  return mesh ? "no failure" : mesh.error().message;
}

const TriangleMesh& cube() {
  static const TriangleMesh mesh = block({0, 0, 0}, {1, 2, 3});
  return mesh;
}

void expect_cube(const base::Outcome<TriangleMesh>& mesh, double volume = 6) {
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->points.size(), 8U);
  EXPECT_EQ(mesh->triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(volume_mm3(*mesh), volume);
}

TEST(StlReader, BinaryAndTextAreTheSameSolid) {
  expect_cube(read(binary_stl(cube())));
  expect_cube(read(text_stl(cube())));
}

TEST(StlReader, ABinaryFileWhoseHeaderSaysSolidIsBinary) {
  expect_cube(read(binary_stl(cube(), "solid made by another program")));
  expect_cube(read(binary_stl(cube(), "solid facet normal" + std::string(62, ' '))));
}

TEST(StlReader, ATextOfAnyPieceAndCaseIsRead) {
  std::string text = text_stl(cube(), "a name of solid facet vertex");
  for (const std::size_t piece : {1U, 2U, 3U, 7U, 50U, 1023U, 1025U})
    expect_cube(read(text, piece));
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  expect_cube(read("  \r\n" + text));
}

TEST(StlReader, ABinaryFileMayComeByteByByte) {
  for (const std::size_t piece : {1U, 3U, 49U, 51U, 84U, 133U, 134U})
    expect_cube(read(binary_stl(cube()), piece));
}

TEST(StlReader, InchesAreMillimetres) {
  expect_cube(read(binary_stl(cube()), 999, 25.4), 6 * 25.4 * 25.4 * 25.4);
}

TEST(StlReader, TwoSolidsInATextAreOneMesh) {
  const auto mesh = read(text_stl(cube()) + text_stl(block({5, 0, 0}, {6, 1, 1}), ""));
  ASSERT_TRUE(mesh);
  EXPECT_DOUBLE_EQ(volume_mm3(*mesh), 7);
}

TEST(StlReader, MinusZeroIsZero) {
  TriangleMesh mesh = cube();
  std::string bytes = binary_stl(mesh);
  bytes[84 + 12 + 3] = '\x80';  // X of the first corner
  expect_cube(read(bytes));
}

TEST(StlReader, AFileThatIsCutOffSaysSo) {
  const std::string binary = binary_stl(cube());
  for (std::size_t size = 1; size < binary.size(); size += 7) {
    std::string message = failure(binary.substr(0, size));
    EXPECT_TRUE(message.find("too short") != std::string::npos ||
                message.find("says that it has 12 triangles") != std::string::npos)
        << size << ": " << message;
  }
  EXPECT_EQ(failure(""), "the file is too short for an STL");
  const std::string text = text_stl(cube());
  EXPECT_EQ(failure(text.substr(0, text.size() - 15)), "line 85: the file ends within a solid");
}

TEST(StlReader, AClaimOf4294967295TrianglesTakesNoMemory) {
  std::string bytes(80, ' ');
  test::put_word(bytes, 0xFFFFFFFFU);
  EXPECT_EQ(failure(bytes),
            "the file is no sound STL: it says that it has 4294967295 triangles, which are "
            "214748364750 bytes, and 0 bytes are there");
}

TEST(StlReader, MoreBytesThanTrianglesAreNotIgnored) {
  EXPECT_NE(failure(binary_stl(cube()) + "more").find("604 bytes are there"), std::string::npos);
}

TEST(StlReader, WhatIsNoNumberIsNamedWithItsPlace) {
  TriangleMesh mesh = cube();
  mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure(binary_stl(mesh)), "triangle 2: a corner has a coordinate that is no number");
  mesh.points[3].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(failure(binary_stl(mesh)), "triangle 2: a corner has a coordinate that is no number");
  std::string text = text_stl(cube());
  text.replace(text.find("vertex 0 0 0"), 12, "vertex 0 nan 0");
  EXPECT_EQ(failure(text), "line 4: nan is no coordinate");
}

TEST(StlReader, WhatIsBeyondEveryMachineIsRefused) {
  TriangleMesh mesh = cube();
  mesh.points[0].x = -250'000;
  EXPECT_EQ(failure(binary_stl(mesh)), "triangle 1: a corner lies at -250000 mm, beyond 100000 mm");
}

TEST(StlReader, WordsOutOfPlaceAreNamedWithTheirLine) {
  EXPECT_EQ(failure("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n"),
            "line 5: vertex is expected, not endloop");
  EXPECT_EQ(failure("solid x\nfacet normal 0 0 1\nouter lop\n"),
            "line 3: loop is expected, not lop");
  EXPECT_EQ(failure("solid x\nfacet " + std::string(200, 'x')), "line 2: a word has no end");
  EXPECT_EQ(failure("solid x\nendsolid x\nmore"), "line 3: solid is expected, not more");
}

TEST(StlReader, TrianglesThatNeedMoreMemoryAreRefusedBeforeTheyAreRead) {
  EXPECT_EQ(failure(binary_stl(cube()), 11),
            "12 triangles are more than the 11 that there is memory for");
  EXPECT_EQ(failure(text_stl(cube()), 11), "line 83: more than 11 triangles");
}

}  // namespace
}  // namespace kerf::mesh
