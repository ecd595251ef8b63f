#include "geometry/contour/offset.hpp"

#include <gtest/gtest.h>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/sweep.hpp"
#include "shapes.hpp"

namespace kerf::contour {
namespace {

using namespace test;  // NOLINT: shapes by their names

constexpr double kSixDecimals = 0.6e-6;

struct Row {
  const char* name;
  Contour shape;
  double distance;
  std::vector<double> areas;
  std::vector<double> lengths;
};

std::vector<Row> table() {
  return {{"rect40x30", rect40x30(), -5, {600.000000}, {100.000000}},
          {"rect40x30", rect40x30(), 5, {1978.539816}, {171.415927}},
          {"rect40x30", rect40x30(), -15.5, {}, {}},
          {"rect40x30", rect40x30(), -15, {}, {}},
          {"rect40x30", rect40x30(), -100, {}, {}},
          {"L", shape_l(), -5, {805.365046}, {177.853982}},
          {"L", shape_l(), 5, {2973.174770}, {249.269908}},
          {"L", shape_l(), -10, {21.460184}, {}},
          {"slot", slot(), -4, {593.097336}, {117.699112}},
          {"slot", slot(), 4, {1735.752160}, {167.964594}},
          {"slot", slot(), -9.5, {40.785398}, {83.141593}},
          {"slot", slot(), -10, {}, {}},
          {"circle20", circle20(), -6, {615.752160}, {87.964594}},
          {"circle20", circle20(), 6, {2123.716634}, {163.362818}},
          {"circle20", circle20(), -20, {}, {}},
          {"circle20", circle20(), -30, {}, {}},
          {"roundrect", roundrect(), -3, {1832.566371}, {172.566371}},
          {"roundrect", roundrect(), -5, {1500.000000}, {160.000000}},
          {"roundrect", roundrect(), -8, {1056.000000}, {136.000000}},
          {"roundrect", roundrect(), 4, {3194.469005}, {216.548668}},
          {"dumbbell", dumbbell(), -2, {1403.433629}, {248.566371}},
          {"dumbbell", dumbbell(), -4, {486.493753, 486.493753}, {88.784497, 88.784497}}};
}

TEST(Offset, HasTheAreasAndLengthsOfTheTable) {
  for (const Row& row : table()) {
    SCOPED_TRACE(std::string(row.name) + " by " + std::to_string(row.distance));
    const Region result = offset(region_of(row.shape), row.distance);
    expect_near(areas(result), row.areas, kSixDecimals);
    if (!row.lengths.empty()) expect_near(lengths(result), row.lengths, kSixDecimals);
  }
}

TEST(Offset, OfSomethingTurnedAndFarAwayIsTheSame) {
  for (const Row& row : table()) {
    SCOPED_TRACE(std::string(row.name) + " by " + std::to_string(row.distance));
    Contour shape = row.shape;
    for (Vertex& vertex : shape.vertices) {
      const Vec2 p = vertex.point;
      vertex.point = Vec2{p.u * 0.8 - p.v * 0.6, p.u * 0.6 + p.v * 0.8} + Vec2{1e5, -1e5};
    }
    expect_near(areas(offset(region_of(shape), row.distance)), row.areas, 1e-5);
  }
}

}  // namespace
}  // namespace kerf::contour
