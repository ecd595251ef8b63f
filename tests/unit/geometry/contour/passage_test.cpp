// What regions sweep along lines and arcs, against points of many moments.
#include "geometry/contour/passage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::contour {
namespace {

using std::numbers::pi;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

/// A star of lines and arcs about the origin, convex or not.
Region random_body(Dice& dice) {
  Contour loop;
  const int count = 3 + static_cast<int>(dice.between(0, 4));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + dice.between(0, 0.7)) / count;
    const double r = dice.between(1, 4);
    const double bulge = dice.between(0, 1) < 0.5 ? 0 : dice.between(-0.3, 0.5);
    loop.vertices.push_back({{r * std::cos(angle), r * std::sin(angle)}, bulge});
  }
  return region_of(loop);
}

Edge random_way(Dice& dice) {
  const Vec2 from{dice.between(-3, 3), dice.between(-3, 3)};
  const Vec2 to = from + Vec2{dice.between(-6, 6), dice.between(-6, 6)};
  return {from, to, dice.between(0, 1) < 0.3 ? 0 : dice.between(-1, 1)};
}

double depth_in(const Region& region, Vec2 point) {
  const double away = distance_to_border(region, point);
  return side_of(region, point, 0) == Side::inside ? away : -away;
}

/// The deepest that the point ever was in the body: positive is certainly swept, and what is not
/// swept was always farther away than a step.
double deepest(const Region& body, const Edge& way, Vec2 point, int steps) {
  double best = -1e9;
  for (int i = 0; i <= steps; ++i)
    best = std::max(best, depth_in(body, point - point_at(way, static_cast<double>(i) / steps)));
  return best;
}

TEST(Passage, HoldsWhatTheBodyWasAtAndNothingElse) {
  Dice dice(86);
  constexpr int kSteps = 200;
  for (int round = 0; round < 60; ++round) {
    const Region body = random_body(dice);
    const Edge way = random_way(dice);
    const double step = length(way) / kSteps;
    const Region all = covered(passage(body, way));
    const Box box = extents(all);
    for (int i = 0; i < 60; ++i) {
      const Vec2 point{dice.between(box.low.u - 1, box.high.u + 1),
                       dice.between(box.low.v - 1, box.high.v + 1)};
      const double depth = deepest(body, way, point, kSteps);
      if (depth > 1e-9) {
        EXPECT_NE(side_of(all, point, 1e-9), Side::outside) << "round " << round;
      } else if (depth < -step) {
        EXPECT_NE(side_of(all, point, 1e-9), Side::inside) << "round " << round;
      }
    }
  }
}

TEST(Passage, AlongLinesIsSweepAlong) {
  Dice dice(87);
  for (int round = 0; round < 50; ++round) {
    const Region body = random_body(dice);
    Edge way = random_way(dice);
    way.bulge = 0;
    way.from = {};
    const Region a = covered(passage(body, way));
    const Region b = sweep_along(body, way.to);
    EXPECT_LT(area(symmetric_difference(a, b)), 1e-7);
  }
}

// Steiner: the area of the sum of two convex bodies; here a disc along an arc is an annular sector.
TEST(Passage, OfADiscAlongAnArcIsAnAnnularSector) {
  for (const double radius : {0.5, 3.0, 7.0}) {
    const Edge way{{5, 0}, {-5, 0}, 1};
    const Region all = covered(passage(disc({}, radius), way));
    // r > R has no hole; the sector's inner border is then inside of the round ends.
    const Region wanted = sweep_of_disc({{{{5, 0}, 1}, {{-5, 0}, 0}}, false}, radius);
    EXPECT_NEAR(area(all), area(wanted), 1e-8 * area(wanted)) << radius;
    EXPECT_LT(area(symmetric_difference(all, wanted)), 1e-7);
  }
}

TEST(Passage, OfAWayWithoutLengthIsTheRegionWhereItStands) {
  const Region all = covered(passage(disc({}, 2), Edge{{3, 4}, {3, 4}}));
  EXPECT_NEAR(area(all), 4 * pi, 1e-9);
  EXPECT_EQ(side_of(all, {3, 5}, 1e-9), Side::inside);
}

TEST(Passage, DividesARegionIntoWhatItCoversAndWhatNot) {
  Dice dice(88);
  for (int round = 0; round < 40; ++round) {
    const Region stock = random_body(dice);
    const std::vector<Contour> tool = passage(random_body(dice), random_way(dice));
    const Division division = divide(stock, tool);
    EXPECT_NEAR(area(division.inside) + area(division.outside), area(stock), 1e-7);
    EXPECT_NEAR(area(division.inside), area(intersect(stock, covered(tool))), 1e-7);
  }
}

}  // namespace
}  // namespace kerf::contour
