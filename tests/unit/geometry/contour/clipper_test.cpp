// Contours against polygons of many corners, as Clipper makes them, and against what areas must add
// up to. KERF_CONTOURS=N tries N pairs of shapes instead of some hundred, KERF_CONTOURS_FIRST=S
// from seed S on.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <polyclipping/clipper.hpp>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "random_shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names
using kerf::test::kSeed;

// Clipper counts in whole numbers; its arcs are chords that leave them by kChord.
constexpr double kPerMm = 1e10;
constexpr double kChord_mm = 1e-4;

void flatten(const Edge& edge, ClipperLib::Path& path) {
  int parts = 1;
  if (edge.bulge != 0) {
    const double step = 2 * std::acos(1 - std::min(1.0, kChord_mm / radius(edge)));
    parts = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep_rad(edge)) / step)));
  }
  for (int i = 0; i < parts; ++i) {
    const Vec2 point = point_at(edge, static_cast<double>(i) / parts);
    path.emplace_back(std::llround(point.u * kPerMm), std::llround(point.v * kPerMm));
  }
}

ClipperLib::Paths flat(const Region& region) {
  ClipperLib::Paths paths;
  for (const Contour& loop : region.loops) {
    paths.emplace_back();
    for (std::size_t i = 0; i < edge_count(loop); ++i) flatten(edge_of(loop, i), paths.back());
  }
  return paths;
}

double clipped(const Region& a, const Region& b, ClipperLib::ClipType type) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(flat(a), ClipperLib::ptSubject, true);
  clipper.AddPaths(flat(b), ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(type, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  double sum = 0;
  for (const ClipperLib::Path& path : result) sum += ClipperLib::Area(path);
  return sum / (kPerMm * kPerMm);
}

double moved(const Region& region, double distance) {
  ClipperLib::ClipperOffset offsetter(2, kChord_mm * kPerMm);
  offsetter.AddPaths(flat(region), ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  ClipperLib::Paths result;
  offsetter.Execute(result, distance * kPerMm);
  double sum = 0;
  for (const ClipperLib::Path& path : result) sum += ClipperLib::Area(path);
  return sum / (kPerMm * kPerMm);
}

Region turned(Region region, double angle) {
  for (Contour& loop : region.loops) {
    for (Vertex& vertex : loop.vertices) {
      const Vec2 p = vertex.point;
      vertex.point = {p.u * std::cos(angle) - p.v * std::sin(angle),
                      p.u * std::sin(angle) + p.v * std::cos(angle)};
    }
  }
  return region;
}

/// What Clipper has that is nearest to an area. It loses some shapes whose hole touches their
/// outline (seed 101112), and has them when they are turned.
double moved_like(const Region& region, double distance, double wanted, double tolerance) {
  double nearest = moved(region, distance);
  for (const double angle : {2.0, 4.0}) {
    if (std::fabs(nearest - wanted) <= tolerance) break;
    const double other = moved(turned(region, angle), distance);
    if (std::fabs(other - wanted) < std::fabs(nearest - wanted)) nearest = other;
  }
  return nearest;
}

unsigned number_of(const char* variable, unsigned otherwise) {
  const char* const wanted = std::getenv(variable);
  return wanted == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(wanted, nullptr, 10));
}
unsigned first_seed() { return number_of("KERF_CONTOURS_FIRST", kSeed); }
unsigned trials() { return number_of("KERF_CONTOURS", 150); }

Region any_shape(SeededRandom& random) {
  const Vec2 middle{random.in(-10, 10), random.in(-10, 10)};
  switch (random.count(0, 3)) {
    case 0: return region_of(random_tangle(random, random.count(3, 12)));
    case 1: return region_of(random_sliver(random, random.count(2, 8)));
    case 2: return region_of(random_touching_discs(random, random.count(2, 5)));
    default: return region_of(random_star(random, middle, 20, random.count(3, 20)));
  }
}

// No border is off by more than two chords' sagittae.
double tolerance_of(const Region& a, const Region& b = {}) {
  return 2 * kChord_mm * (length(a) + length(b)) + 1e-6;
}

// Of what rounding adds to areas of some hundred mm².
constexpr double kSame_mm2 = 1e-6;

void expect_agreement(unsigned seed) {
  SeededRandom random(seed);
  const Region a = any_shape(random);
  const Region b = any_shape(random);
  const double tolerance = tolerance_of(a, b);
  const double united = area(unite(a, b));
  const double common = area(intersect(a, b));
  EXPECT_NEAR(united, clipped(a, b, ClipperLib::ctUnion), tolerance) << seed;
  EXPECT_NEAR(common, clipped(a, b, ClipperLib::ctIntersection), tolerance) << seed;
  EXPECT_NEAR(area(subtract(a, b)), clipped(a, b, ClipperLib::ctDifference), tolerance) << seed;
  EXPECT_NEAR(area(symmetric_difference(a, b)), clipped(a, b, ClipperLib::ctXor), tolerance)
      << seed;
  EXPECT_NEAR(united + common, area(a) + area(b), kSame_mm2) << seed;
}

TEST(Boolean, AgreesWithPolygonsOfManyCorners) {
  for (unsigned seed = first_seed(); seed != first_seed() + trials(); ++seed)
    expect_agreement(seed);
}

// A crossing that rounding puts a little behind the end of an arc, in a cusp between discs.
TEST(Boolean, AgreesWithPolygonsWhereArcsMeetBehindTheirEnds) { expect_agreement(3054567); }

TEST(Offset, AgreesWithPolygonsOfManyCorners) {
  for (unsigned seed = first_seed(); seed != first_seed() + trials(); ++seed) {
    SeededRandom random(seed);
    const Region shape = any_shape(random);
    const double by = random.in(-6, 6);
    const Region result = offset(shape, by);
    const double tolerance = tolerance_of(shape, result);
    EXPECT_NEAR(area(result), moved_like(shape, by, area(result), tolerance), tolerance)
        << seed << " by " << by;
    const double in = std::fabs(by);
    const Region opened = offset(offset(shape, -in), in);
    EXPECT_NEAR(area(subtract(opened, shape)), 0, kSame_mm2) << seed << " by " << by;
  }
}

}  // namespace
}  // namespace kerf::contour
