#include "stock/compare/mesh_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stock/compare/deviation.hpp"
#include "stock/compare/meshes.hpp"

namespace kerf::stock::compare::test {
namespace {

double distance(const MeshSolid& solid, Vec3 place) {
  Hint hint;
  return solid.near(place, hint).distance_mm;
}

/// Of a box, written out.
double from_box(Vec3 low, Vec3 high, Vec3 p) {
  const Vec3 out{std::max({low.x - p.x, p.x - high.x}), std::max({low.y - p.y, p.y - high.y}),
                 std::max({low.z - p.z, p.z - high.z})};
  const Vec3 positive{std::max(out.x, 0.0), std::max(out.y, 0.0), std::max(out.z, 0.0)};
  return std::sqrt(dot(positive, positive)) + std::min(0.0, std::max({out.x, out.y, out.z}));
}

/// Distance to a triangle by its parts: the plane within, else the three edges.
double from_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  const auto from_edge = [&](Vec3 u, Vec3 v) {
    const double t = std::clamp(dot(p - u, v - u) / dot(v - u, v - u), 0.0, 1.0);
    return length(p - (u + t * (v - u)));
  };
  const Vec3 n = unit(cross(b - a, c - a));
  const bool is_within = dot(cross(b - a, p - a), n) >= 0 && dot(cross(c - b, p - b), n) >= 0 &&
                         dot(cross(a - c, p - c), n) >= 0;
  return is_within ? std::fabs(dot(p - a, n))
                   : std::min({from_edge(a, b), from_edge(b, c), from_edge(c, a)});
}

/// How often a mesh goes round a place: the solid angles that its triangles are seen at, by van
/// Oosterom's formula.
double winding(const TriangleMesh& mesh, Vec3 p) {
  double sum = 0;
  for (const mesh::Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]] - p;
    const Vec3 b = mesh.points[t[1]] - p;
    const Vec3 c = mesh.points[t[2]] - p;
    const double la = length(a);
    const double lb = length(b);
    const double lc = length(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

double brute(const TriangleMesh& mesh, Vec3 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::Triangle& t : mesh.triangles)
    least =
        std::min(least, from_triangle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], p));
  return winding(mesh, p) > 0.5 ? -least : least;
}

void agrees_with_all_triangles(const TriangleMesh& mesh, Vec3 low, Vec3 high, std::uint64_t seed,
                               int count) {
  const MeshSolid solid(mesh);
  Random random(seed);
  Hint hint;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = random.in(low, high);
    const double wanted = brute(mesh, p);
    EXPECT_NEAR(solid.near(p, hint).distance_mm, wanted, 1e-12) << p.x << " " << p.y << " " << p.z;
    EXPECT_EQ(distance(solid, p), solid.near(p, hint).distance_mm) << "the hint changes nothing";
    if (std::fabs(wanted) > 1e-9) {
      EXPECT_EQ(solid.holds(p), wanted < 0);
    }
  }
}

TEST(MeshSolid, ABoxIsAsFarAsItsFormulaSays) {
  const Vec3 low{-3, 1, -2};
  const Vec3 high{5, 4, 7};
  const MeshSolid solid(box(low, high));
  // On a lattice through faces, edges, corners and diagonals, where features tie.
  for (double x = -6; x <= 8; x += 0.5) {
    for (double y = -2; y <= 7; y += 0.5) {
      for (double z = -5; z <= 10; z += 0.5) {
        const Vec3 p{x, y, z};
        ASSERT_NEAR(distance(solid, p), from_box(low, high, p), 1e-12) << x << " " << y << " " << z;
      }
    }
  }
}

TEST(MeshSolid, ABallIsAsFarAsItsTrianglesAre) {
  agrees_with_all_triangles(ball(5, 2), {-8, -8, -8}, {8, 8, 8}, 1, 2000);
}

TEST(MeshSolid, TheSideIsRightBeforeAcuteEdgesAndCorners) {
  // A needle and a blade: the nearest point is their edge, whose one face looks away.
  const TriangleMesh blade = prism({{0, 0}, {10, -0.2}, {10, 0.2}}, 0, 4);
  agrees_with_all_triangles(blade, {-3, -2, -2}, {12, 2, 6}, 2, 3000);
  const MeshSolid solid(blade);
  EXPECT_NEAR(distance(solid, {-1, 0.3, 2}), std::hypot(1, 0.3), 1e-12);
  EXPECT_NEAR(distance(solid, {-1, -0.3, 2}), std::hypot(1, 0.3), 1e-12);
  EXPECT_LT(distance(solid, {9, 0, 2}), 0);
}

TEST(MeshSolid, TheSideIsRightAtCornersThatAreSaddles) {
  // Star shaped outlines have corners in and out, and corners where both meet.
  Random random(3);
  for (int shape = 0; shape < 12; ++shape) {
    std::vector<std::array<double, 2>> outline{{0, 0}};
    for (int i = 0; i <= 8; ++i) {
      const double angle = 1.4 * i / 8;
      const double r = random.in(2, 9);
      outline.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    TriangleMesh mesh = prism(outline, 0, 5);
    for (Vec3& p : mesh.points) p = p + random.in({-0.05, -0.05, -0.4}, {0.05, 0.05, 0.4});
    agrees_with_all_triangles(mesh, {-2, -2, -2}, {10, 10, 7},
                              10 + static_cast<std::uint64_t>(shape), 250);
  }
}

TEST(MeshSolid, ACavityIsOutside) {
  const TriangleMesh hollow = with(ball(6, 2), turned(ball(3, 2)));
  agrees_with_all_triangles(hollow, {-7, -7, -7}, {7, 7, 7}, 4, 1000);
  EXPECT_GT(distance(MeshSolid(hollow), {0.1, 0.2, 0.3}), 2);
}

TEST(MeshSolid, FoldsAndTrianglesWithoutAreaDoNotTurnTheSide) {
  // The top's diagonal is a triangle without area, and then one that is folded over by a trace.
  for (const double aside : {0.0, 1e-9, -1e-9}) {
    TriangleMesh mesh = box({0, 0, 0}, {4, 4, 1});
    const auto middle = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({2 + aside, 2 - aside, 1});
    // The top is 4 5 6 and 4 6 7: of the second the side 4 6 gets a corner, and a sliver fills it.
    std::erase_if(mesh.triangles, [](const mesh::Triangle& t) {
      return t == mesh::Triangle{4, 6, 7};
    });
    mesh.triangles.push_back({4, middle, 7});
    mesh.triangles.push_back({middle, 6, 7});
    mesh.triangles.push_back({4, 6, middle});
    const MeshSolid solid(mesh);
    for (double at = 0.25; at < 4; at += 0.25) {
      EXPECT_NEAR(distance(solid, {at, at, 1.5}), 0.5, 1e-8) << aside << " " << at;
      EXPECT_NEAR(distance(solid, {at, at, 0.9}), -0.1, 1e-8) << aside << " " << at;
    }
  }
}

TEST(MeshSolid, LinesGoInAndOutWhereTheyDo) {
  const MeshSolid solid(with(box({0, 0, 0}, {4, 4, 10}), turned(box({1, 1, 2}, {3, 3, 5}))));
  // Also through diagonals, edges and corners.
  for (double x = -0.5; x <= 4.5; x += 0.25) {
    for (double y = -0.5; y <= 4.5; y += 0.25) {
      std::vector<Stretch> found;
      solid.inside(2, x, y, found);
      const bool is_border = x == 0 || x == 4 || y == 0 || y == 4;
      const bool is_inner_border =
          ((x == 1 || x == 3) && y >= 1 && y <= 3) || ((y == 1 || y == 3) && x >= 1 && x <= 3);
      if (is_border || is_inner_border) continue;
      const bool is_in = x > 0 && x < 4 && y > 0 && y < 4;
      const bool is_over_cavity = x > 1 && x < 3 && y > 1 && y < 3;
      ASSERT_EQ(found.size(), is_over_cavity ? 2U : is_in ? 1U : 0U) << x << " " << y;
      if (!is_in) continue;
      EXPECT_NEAR(found.front().low, 0, 1e-12);
      EXPECT_NEAR(found.back().high, 10, 1e-12);
      if (!is_over_cavity) continue;
      EXPECT_NEAR(found[0].high, 2, 1e-12);
      EXPECT_NEAR(found[1].low, 5, 1e-12);
    }
  }
}

TEST(MeshSolid, LinesThroughABallAreItsVolume) {
  const TriangleMesh mesh = ball(5, 3);
  const MeshSolid solid(mesh);
  for (int axis = 0; axis < 3; ++axis) {
    double sum = 0;
    for (double b = -4.975; b < 5; b += 0.05) {
      for (double c = -4.975; c < 5; c += 0.05) {
        std::vector<Stretch> found;
        solid.inside(axis, b, c, found);
        for (const Stretch& one : found) sum += one.high - one.low;
      }
    }
    EXPECT_NEAR(sum * 0.05 * 0.05, volume_mm3(mesh), 0.0005 * volume_mm3(mesh)) << axis;
  }
}

TEST(MeshSolid, ShellsThatOverlapAreOneSolid) {
  const MeshSolid solid(with(box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3})));
  std::vector<Stretch> found;
  solid.inside(0, 2, 2, found);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].low, 0, 1e-12);
  EXPECT_NEAR(found[0].high, 6, 1e-12);
}

TEST(MeshSolid, ItsPointsAreNoFartherApartThanAsked) {
  const TriangleMesh mesh = box({0, 0, 0}, {7, 3, 2});
  const MeshSolid solid(mesh);
  std::vector<SurfacePoint> points;
  for (std::size_t row = 0; row < solid.rows(); ++row) solid.points(row, 0.5, points);
  double area = 0;
  for (const SurfacePoint& point : points) area += point.area_mm2;
  EXPECT_NEAR(area, 2 * (21 + 14 + 6), 1e-9);
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Vec3 on_top{random.in(0, 7), random.in(0, 3), 2};
    double least = 100;
    for (const SurfacePoint& point : points) least = std::min(least, length(point.at - on_top));
    EXPECT_LE(least, 0.5) << on_top.x << " " << on_top.y;
  }
}

TEST(Deviation, ThreadsChangeNoBit) {
  const MeshSolid solid(ball(5, 3));
  Random random(6);
  std::vector<Vec3> places;
  for (int i = 0; i < 5000; ++i) places.push_back(random.in({-7, -7, -7}, {7, 7, 7}));
  const std::vector<float> one = deviations_mm(solid, places, 1);
  EXPECT_EQ(one, deviations_mm(solid, places, 3));
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_NEAR(one[i], length(places[i]) - 5, 0.03);
}

}  // namespace
}  // namespace kerf::stock::compare::test
