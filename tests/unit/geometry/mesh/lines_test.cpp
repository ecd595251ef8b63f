#include "geometry/mesh/lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/mesh/meshes.hpp"

namespace kerf::mesh {
namespace {

using test::block;
using test::both;
using test::turned;

constexpr double kLeast = 1e-5;

std::vector<double> places(double first, double step, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(first + step * i);
  return out;
}

/// Σ of what lies inside, times the area of a cell.
double volume_by_lines(const TriangleMesh& mesh, const LineGrid& grid) {
  const Lines lines(mesh, grid);
  double sum = 0;
  std::vector<Stretch> found;
  for (std::size_t c = 0; c < grid.c.size(); ++c) {
    for (std::size_t b = 0; b < grid.b.size(); ++b) {
      found.clear();
      lines.inside(b, c, kLeast, found);
      for (const Stretch& s : found) sum += s.high - s.low;
    }
  }
  return sum * (grid.b[1] - grid.b[0]) * (grid.c[1] - grid.c[0]);
}

/// The axes one further: what was along X is along Y.
TriangleMesh moved_on(TriangleMesh mesh) {
  for (Vec3& p : mesh.points) p = {p.z, p.x, p.y};
  return mesh;
}

// Lines through all corners and along faces and edges: those on the lower faces are in, those on
// the upper ones out, so that the sum is the volume to the last bit.
TEST(Lines, ThroughCornersAndAlongEdgesCountOnce) {
  TriangleMesh mesh = block({0, 0, 0}, {4, 6, 5});
  for (int axis : {2, 0, 1}) {
    const auto grid = LineGrid{axis, places(-2, 1, 12), places(-2, 1, 12)};
    EXPECT_EQ(volume_by_lines(mesh, grid), 120);
    mesh = moved_on(mesh);
  }
}

TEST(Lines, ShellsThatTouchAreOneAndCavitiesAreNone) {
  const LineGrid grid{2, places(0.5, 1, 10), places(0.5, 1, 10)};
  std::vector<Stretch> found;
  const TriangleMesh touching = both(block({0, 0, 0}, {10, 10, 3}), block({0, 0, 3}, {10, 10, 8}));
  Lines(touching, grid).inside(4, 4, kLeast, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].low, 0);
  EXPECT_EQ(found[0].high, 8);
  found.clear();
  const TriangleMesh hollow =
      both(block({0, 0, 0}, {10, 10, 10}), turned(block({2, 2, 2}, {8, 8, 8})));
  const Lines lines(hollow, grid);
  EXPECT_FALSE(lines.is_wound_otherwise());
  lines.inside(4, 4, kLeast, found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].high, 2);
  EXPECT_EQ(found[1].low, 8);
}

TEST(Lines, ShellsThatOverlapAreOneSolid) {
  const TriangleMesh mesh = both(block({0, 0, 0}, {10, 10, 6}), block({0, 0, 4}, {10, 10, 9}));
  const LineGrid grid{2, places(0.5, 1, 10), places(0.5, 1, 10)};
  EXPECT_EQ(volume_by_lines(mesh, grid), 900);
  EXPECT_TRUE(Lines(mesh, grid).is_wound_otherwise());
}

/// Cubes of 1 in a block of 6 x 6 x 6, each a shell of its own: faces that coincide, edges and
/// corners at which any number of them touch.
class Voxels {
 public:
  static constexpr int kSide = 6;

  explicit Voxels(unsigned seed) {
    std::mt19937 random(seed);
    for (bool& one : full_) one = random() % 2 == 0;
  }
  [[nodiscard]] bool at(int x, int y, int z) const {
    const auto in = [](int i) { return i >= 0 && i < kSide; };
    return in(x) && in(y) && in(z) && full_[static_cast<std::size_t>((z * kSide + y) * kSide + x)];
  }
  /// Leaning: a point at (x, y) is 2 x + 3 y higher.
  [[nodiscard]] TriangleMesh mesh() const {
    TriangleMesh mesh;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const int x = i % kSide, y = i / kSide % kSide, z = i / kSide / kSide;
      const Vec3 low{1.0 * x, 1.0 * y, 1.0 * z};
      if (at(x, y, z)) mesh = both(std::move(mesh), block(low, low + Vec3{1, 1, 1}));
    }
    for (Vec3& p : mesh.points) p.z += 2 * p.x + 3 * p.y;
    return mesh;
  }
  /// Of the line that stands a little beyond (x, y).
  [[nodiscard]] std::vector<Stretch> expected(double x, double y) const {
    std::vector<Stretch> out;
    const double lift = 2 * x + 3 * y;
    const auto full = [&](int z) {
      return at(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)), z);
    };
    for (int z = 0; z < kSide; ++z) {
      if (full(z) && !full(z - 1)) out.push_back({z + lift, 0});
      if (full(z)) out.back().high = z + 1 + lift;
    }
    return out;
  }

 private:
  std::array<bool, kSide * kSide * kSide> full_{};
};

// Lines run along faces, along the diagonals of faces and through corners, of solids that lean.
TEST(Lines, NeitherLoseNorDoubleAnEndAmongTouchingCubes) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Voxels voxels(seed);
    const LineGrid grid{2, places(-0.5, 0.25, 30), places(-0.5, 0.25, 30)};
    const Lines lines(voxels.mesh(), grid);
    for (std::size_t c = 0; c < grid.c.size(); ++c) {
      for (std::size_t b = 0; b < grid.b.size(); ++b) {
        std::vector<Stretch> found;
        lines.inside(b, c, kLeast, found);
        const auto expected = voxels.expected(grid.b[b], grid.c[c]);
        ASSERT_EQ(found.size(), expected.size()) << seed << ": " << grid.b[b] << ", " << grid.c[c];
        for (std::size_t i = 0; i < found.size(); ++i) {
          EXPECT_DOUBLE_EQ(found[i].low, expected[i].low);
          EXPECT_DOUBLE_EQ(found[i].high, expected[i].high);
        }
      }
    }
  }
}

/// A ball of triangles between circles of latitude, its poles on the axis.
TriangleMesh ball(double radius, std::uint32_t rings, std::uint32_t sectors) {
  TriangleMesh mesh{.points = {{0, 0, -radius}, {0, 0, radius}}, .triangles = {}};
  for (std::uint32_t i = 1; i < rings; ++i) {
    const double up = std::numbers::pi * (i / (1.0 * rings) - 0.5);
    for (std::uint32_t j = 0; j < sectors; ++j) {
      const double round = 2 * std::numbers::pi * j / sectors;
      mesh.points.push_back({radius * std::cos(up) * std::cos(round),
                             radius * std::cos(up) * std::sin(round), radius * std::sin(up)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return 2 + (i - 1) * sectors + j % sectors;
  };
  for (std::uint32_t j = 0; j < sectors; ++j) {
    mesh.triangles.push_back({0, at(1, j + 1), at(1, j)});
    for (std::uint32_t i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh.triangles.push_back({at(rings - 1, j), at(rings - 1, j + 1), 1});
  }
  return mesh;
}

double on_axis(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

TEST(Lines, OfABallHaveItsVolumeAlongEachAxis) {
  const TriangleMesh mesh = ball(10, 60, 97);
  const double volume = volume_mm3(mesh);
  for (const int axis : {0, 1, 2}) {
    const LineGrid grid{axis, places(-10.05, 0.1, 202), places(-10.05, 0.1, 202)};
    EXPECT_NEAR(volume_by_lines(mesh, grid), volume, volume * 2e-4) << axis;
    EXPECT_NEAR(on_axis(seen_mm2(mesh), axis) / 0.01,
                static_cast<double>(Lines(mesh, grid).crossings()), 600);
  }
}

TEST(Lines, EveryLineThroughARandomTangleEntersAsOftenAsItLeaves) {
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<double>(random() % 9) - 4; };
  for (int trial = 0; trial < 300; ++trial) {
    TriangleMesh mesh;
    for (int i = 0; i < 4; ++i) {
      const Vec3 from{number(), number(), number()};
      TriangleMesh tetrahedron{.points = {from, {}, {}, {}},
                               .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
      for (std::size_t k = 1; k < 4; ++k) tetrahedron.points[k] = {number(), number(), number()};
      mesh = both(std::move(mesh), volume_mm3(tetrahedron) < 0 ? turned(tetrahedron) : tetrahedron);
    }
    for (const int axis : {0, 1, 2}) {
      const LineGrid grid{axis, places(-4, 1, 9), places(-4, 0.5, 17)};
      const Lines lines(mesh, grid);
      for (std::size_t i = 0; i < grid.b.size() * grid.c.size(); ++i) {
        std::vector<Stretch> found;
        lines.inside(i % 9, i / 9, kLeast, found);
        for (const Stretch& s : found) {
          ASSERT_LT(s.low, s.high);
          ASSERT_GE(s.low, -4);
          ASSERT_LE(s.high, 4);
        }
      }
      EXPECT_EQ(lines.crossings() % 2, 0U);
    }
  }
}

}  // namespace
}  // namespace kerf::mesh
