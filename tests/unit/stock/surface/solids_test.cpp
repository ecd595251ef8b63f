// Surfaces of turned parts, plates and height fields as they are; pieces of surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../field/field_jobs.hpp"
#include "geometry/contour/boolean.hpp"
#include "soundness.hpp"
#include "stock/surface/height_steps.hpp"
#include "stock/surface/pieces.hpp"
#include "stock/surface/plate_surface.hpp"
#include "stock/surface/turned_surface.hpp"
#include "stock/turned/revolved.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::surface::test {
namespace {

constexpr double kPi = 3.141592653589793;

void expect_sound(const Surface& surface, long euler, double volume, double share = 1e-3) {
  const Soundness found = soundness(surface);
  EXPECT_TRUE(found.is_sound()) << found.text();
  EXPECT_EQ(found.euler, euler) << found.text();
  EXPECT_NEAR(found.volume_mm3, volume, share * volume) << found.text();
}

contour::Region square(double low, double high) {
  return {{{.vertices = {{{low, low}}, {{high, low}}, {{high, high}}, {{low, high}}}}}};
}

// Of the volume what float32 and a fixed number of tries leave.
constexpr double kSameVolume = 1e-7;

TEST(TurnedSurface, OfABarHasItsVolumeAndItsDiameterWithinTheTolerance) {
  const Surface surface = turned(turned::bar(40, -30, 0), 0.002);
  expect_sound(surface, 2, kPi * 400 * 30, kSameVolume);
  double widest = 0;
  for (const auto& p : surface.mesh.points) widest = std::max(widest, std::hypot(p.x, p.y));
  EXPECT_NEAR(widest, 20, 0.002);
  // A chord of the polygon is nearer to the axis in its middle, and not by more.
  const double step = 2 * kPi / (static_cast<double>(surface.mesh.points.size() - 2) / 2);
  EXPECT_NEAR(widest * std::cos(step / 2), 20, 0.002);
}

TEST(TurnedSurface, OfATubeHasAHandle) {
  expect_sound(turned(turned::bar(40, -30, 0, 20), 0.002), 0, kPi * 300 * 30, kSameVolume);
}

TEST(TurnedSurface, OfABallIsRound) {
  const contour::Region half =
      contour::intersect(contour::disc({0, 0}, 10),
                         {{{.vertices = {{{-11, 0}}, {{11, 0}}, {{11, 11}}, {{-11, 11}}}}}});
  expect_sound(turned(half, 0.002), 2, 4.0 / 3 * kPi * 1000, kSameVolume);
  expect_sound(turned(half, 0.2), 2, 4.0 / 3 * kPi * 1000, kSameVolume);
}

// Convex and hollow arcs, a bore with a round bottom, a groove that leans over.
TEST(TurnedSurface, HoldsTheVolumeOfItsRegionAndStaysWithinTheTolerance) {
  contour::Region part = turned::bar(50, -80, 0);
  part = contour::subtract(part, contour::disc({-20, 25}, 6));
  part = contour::unite(part, contour::disc({-55, 24}, 5));
  part = contour::subtract(part, contour::disc({0, 0}, 9));
  part = contour::subtract(part,
                           {{{.vertices = {{{-40, 20}}, {{-38, 20}}, {{-33, 30}}, {{-35, 30}}}}}});
  for (const double tolerance : {0.002, 0.02, 0.1}) {
    const Surface surface = turned(part, tolerance);
    expect_sound(surface, 2, turned::volume(part), kSameVolume);
    for (const auto& p : surface.mesh.points) {
      const contour::Vec2 at{p.z, std::hypot(p.x, p.y)};
      if (at.v < 1e-6) continue;
      EXPECT_LE(contour::distance_to_border(part, at), tolerance);
    }
  }
}

TEST(TurnedSurface, CutOpenItShowsTwoSections) {
  const Surface open = turned_open(turned::bar(40, -30, 0, 20), 0.002, kPi / 2, 1.5 * kPi);
  expect_sound(open, 2, 0.75 * kPi * 300 * 30);
  double section = 0;
  for (std::size_t i = 0; i < open.owners.size(); ++i) {
    if (open.owners[i] != kSection) continue;
    const auto& t = open.mesh.triangles[i];
    const auto a = open.mesh.points[t[0]];
    section += length(cross(open.mesh.points[t[1]] - a, open.mesh.points[t[2]] - a)) / 2;
  }
  EXPECT_NEAR(section, 2 * 10 * 30, 1e-6);
}

TEST(PlateSurface, WithHolesAndIslandsIsSound) {
  const contour::Region ring = contour::subtract(square(0, 30), contour::disc({15, 15}, 10));
  const contour::Region all = contour::unite(ring, square(12, 18));
  expect_sound(plate(all, -2, 0, 0.002), 2, 2 * (900 - kPi * 100 + 36));
}

TEST(PlateSurface, WithManyHolesHasAsManyHandles) {
  std::mt19937 random(7);
  contour::Region sheet = square(0, 100);
  std::vector<contour::Region> holes;
  double area = 10000;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const double r = 1 + static_cast<double>(random() % 1000) / 250;
      holes.push_back(contour::disc({6 + 12.0 * i + (j % 2), 6 + 12.0 * j}, r));
      area -= kPi * r * r;
    }
  }
  sheet = contour::subtract(sheet, contour::unite(holes));
  expect_sound(plate(sheet, 0, 3, 0.002), 2 - 2 * 64, 3 * area);
}

TEST(PlateSurface, OfACombWithManyTeethIsSound) {
  contour::Contour comb;
  for (int i = 0; i < 200; ++i) {
    comb.vertices.push_back({{1.0 * i, i % 2 == 0 ? 0.0 : 40.0 + i % 7}});
  }
  comb.vertices.push_back({{199, 60}});
  comb.vertices.push_back({{0, 60}});
  const contour::Region region = contour::region_of(comb);
  expect_sound(plate(region, 0, 1, 0.01), 2, contour::area(region));
}

TEST(HeightSteps, AreThePostsThemselves) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const field::Grid grid = field::grid_of({{0, 0, 0}, {8, 7, 5}}, 1);
    // Few heights, so that edges and corners touch; some posts hang.
    const field::Columns columns(grid, [&](double, double) {
      const double low = random() % 3 == 0 ? 0 : static_cast<double>(random() % 4);
      return field::Column{low, static_cast<double>(random() % 6)};
    });
    const Soundness found = soundness(height_steps(columns));
    EXPECT_TRUE(found.is_sound()) << seed << ": " << found.text();
    EXPECT_NEAR(found.volume_mm3, columns.volume_mm3(), 0.01 * columns.volume_mm3());
  }
}

TEST(HeightSteps, OfASlotHaveItsVolume) {
  field::Job job({{0, 0, -20}, {40, 30, 0}}, 0.5, field::flat(10));
  job.at({-10, 15, -5}).to({50, 15, -5});
  expect_sound(height_steps(job.field().columns()), 2, job.field().left_mm3(), 1e-6);
}

TEST(PiecesOfASurface, HaveTheirCavitiesAndTheLargestIsFirst) {
  Surface all;
  const auto add = [&](double low, double high, bool is_cavity) {
    Surface box = plate(square(low, high), low, high, 0.01);
    const auto first = static_cast<std::uint32_t>(all.mesh.points.size());
    all.mesh.points.insert(all.mesh.points.end(), box.mesh.points.begin(), box.mesh.points.end());
    all.point_owners.resize(all.mesh.points.size());
    for (mesh::Triangle t : box.mesh.triangles) {
      if (is_cavity) std::swap(t[1], t[2]);
      all.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
      all.owners.push_back(0);
    }
  };
  add(30, 34, false);
  add(0, 10, false);
  add(4, 6, true);
  const std::vector<Surface> pieces = pieces_of(all);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(mesh::volume_mm3(pieces[0].mesh), 1000 - 8, 1e-9);
  EXPECT_NEAR(mesh::volume_mm3(pieces[1].mesh), 64, 1e-9);
}

}  // namespace
}  // namespace kerf::stock::surface::test
