#include "control/gcode/frames/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "seeded_random.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisVector;
using geometry::sine_cosine_deg;
using geometry::SineCosine;
using geometry::Vec2;
using test::kSeed;
using test::SeededRandom;

constexpr int kCases = 50'000;
constexpr motion::PlaneAxes kXY{Axis{0}, Axis{1}, Axis{2}, 'I', 'J'};
constexpr motion::PlaneAxes kZX{Axis{2}, Axis{0}, Axis{1}, 'K', 'I'};
constexpr motion::PlaneAxes kYZ{Axis{1}, Axis{2}, Axis{0}, 'J', 'K'};

AxisVector random_point(SeededRandom& random) {
  return {{random.in(-500, 500), random.in(-500, 500), random.in(-500, 500)}};
}
motion::PlaneAxes random_plane(SeededRandom& random) {
  const int which = random.count(0, 2);
  return which == 0 ? kXY : which == 1 ? kZX : kYZ;
}
// Not near 0, of either sign.
double random_factor(SeededRandom& random) {
  return (random.coin() ? 1 : -1) * random.size(0.1, 10);
}
double random_angle(SeededRandom& random) {
  return random.coin() ? 90 * random.count(-8, 8) : random.in(-720, 720);
}

struct Recipe {
  Transform transform;
  std::string text;
};

// Any mixture of scaling, mirror image and rotation.
Recipe random_transform(SeededRandom& random, const motion::PlaneAxes& plane) {
  Recipe recipe;
  if (random.coin()) {
    const AxisVector factors{{random_factor(random), random_factor(random), random_factor(random)}};
    recipe.transform.scale(random_point(random), factors);
    recipe.text += " scaled by " + std::to_string(factors.values[0]) + ", " +
                   std::to_string(factors.values[1]) + ", " + std::to_string(factors.values[2]);
  }
  for (std::uint8_t i = 0; i < 3; ++i) {
    if (!random.coin()) continue;
    recipe.transform.mirror(Axis{i}, random.in(-100, 100));
    recipe.text += " mirrored in axis " + std::to_string(i);
  }
  if (random.coin()) {
    const double angle = random_angle(random);
    recipe.transform.rotate(plane, {random.in(-100, 100), random.in(-100, 100)}, angle);
    recipe.text += " rotated by " + std::to_string(angle);
  }
  return recipe;
}

void expect_near(const AxisVector& got, const AxisVector& wanted, double tolerance,
                 const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_NEAR(got.values[i], wanted.values[i], tolerance) << "axis " << i << ":" << what;
}

TEST(Transform, InvertUndoesApply) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Recipe recipe = random_transform(random, random_plane(random));
    const AxisVector point = random_point(random);
    expect_near(recipe.transform.invert(recipe.transform.apply(point)), point, 1e-9, recipe.text);
    expect_near(recipe.transform.apply(recipe.transform.invert(point)), point, 1e-8, recipe.text);
  }
}

TEST(Transform, OfNothingLeavesEveryPoint) {
  SeededRandom random(kSeed);
  const Transform identity;
  EXPECT_TRUE(identity.identity());
  for (int i = 0; i < 100; ++i) {
    const AxisVector point = random_point(random);
    EXPECT_EQ(identity.apply(point), point);
    EXPECT_EQ(identity.invert(point), point);
  }
}

TEST(Transform, IsTheFormulaOfTheSpecification) {  // §8.5: mirror, then scale, then rotation
  Transform transform;
  transform.mirror(Axis{0}, 10);              // x' = 20 - x
  transform.scale({{1, 2, 3}}, {{2, 3, 4}});  // c + k (p - c)
  expect_near(transform.apply({{5, 6, 7}}), {{29, 14, 19}}, 1e-12, "mirror, then scale");
  Transform turned;
  turned.rotate(kXY, {1, 1}, 90);
  expect_near(turned.apply({{3, 1, 5}}), {{1, 3, 5}}, 1e-15, "a quarter turn");
}

TEST(Transform, AMirroredPlaneTurnsTheOtherWay) {
  Transform transform;
  transform.rotate(kXY, {0, 0}, 30);
  transform.mirror(Axis{0}, 0);
  // (10, 0) is mirrored to (-10, 0) and turned by -30 degrees.
  expect_near(transform.apply({{10, 0, 0}}), {{-10 * std::cos(std::numbers::pi / 6), 5, 0}}, 1e-12,
              "mirrored rotation");
}

// Twice the signed area of a triangle in a plane.
double area(const Transform& transform, const motion::PlaneAxes& plane, const AxisVector& a,
            const AxisVector& b, const AxisVector& c) {
  const Vec2 p = plane.project(transform.apply(a));
  return geometry::cross(plane.project(transform.apply(b)) - p,
                         plane.project(transform.apply(c)) - p);
}

TEST(Transform, ReversesSaysWhetherATriangleTurnsOver) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const motion::PlaneAxes plane = random_plane(random);
    const Recipe recipe = random_transform(random, plane);
    AxisVector a = random_point(random);
    AxisVector b = a;
    AxisVector c = a;
    b[plane.first] += 10;
    c[plane.second] += 10;
    const bool turned_over = area(recipe.transform, plane, a, b, c) < 0;
    ASSERT_EQ(recipe.transform.reverses(plane), turned_over) << recipe.text;
  }
}

TEST(Transform, ALengthInThePlaneGrowsByTheFactorWhenBothAreEqual) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double k = random_factor(random);
    Transform transform;
    transform.scale(random_point(random), {{k, k, random_factor(random)}});
    if (random.coin()) transform.mirror(Axis{0}, 5);
    transform.rotate(kXY, {3, 4}, random_angle(random));
    const AxisVector a = random_point(random);
    AxisVector b = random_point(random);
    b.values[2] = a.values[2];
    const double before = geometry::length(kXY.project(a) - kXY.project(b));
    const double after =
        geometry::length(kXY.project(transform.apply(a)) - kXY.project(transform.apply(b)));
    ASSERT_NEAR(after, before * transform.radius_factor(kXY), 1e-9 * after);
  }
}

TEST(Transform, EachPartCanBeCancelledAlone) {
  Transform transform;
  transform.scale({}, {{2, 2, 2}});
  transform.mirror(Axis{1}, 5);
  transform.rotate(kXY, {}, 45);
  transform.cancel_rotation();
  expect_near(transform.apply({{1, 1, 1}}), {{2, 18, 2}}, 1e-12, "without the rotation");
  transform.cancel_scaling();
  expect_near(transform.apply({{1, 1, 1}}), {{1, 9, 1}}, 1e-12, "without the scaling");
  transform.cancel_mirror(Axis{1});
  EXPECT_TRUE(transform.identity());
}

TEST(SineCosine, IsExactAtMultiplesOfNinetyDegrees) {
  for (int quarter = -12; quarter <= 12; ++quarter) {
    const SineCosine at = sine_cosine_deg(90.0 * quarter);
    const int phase = ((quarter % 4) + 4) % 4;
    EXPECT_EQ(at.sine, phase == 1 ? 1 : phase == 3 ? -1 : 0) << 90 * quarter;
    EXPECT_EQ(at.cosine, phase == 0 ? 1 : phase == 2 ? -1 : 0) << 90 * quarter;
  }
}

TEST(SineCosine, OfManyTurnsIsThatOfTheRest) {
  for (const double angle : {1e15 + 0.5, 1e19, -1e22, 1e30, 1.7e308}) {
    const SineCosine at = sine_cosine_deg(angle);
    const SineCosine of_rest = sine_cosine_deg(std::fmod(angle, 360));
    EXPECT_EQ(at.sine, of_rest.sine) << angle;
    EXPECT_EQ(at.cosine, of_rest.cosine) << angle;
  }
}

TEST(SineCosine, IsThatOfTheLibraryEverywhereElse) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const double angle = random.in(-1000, 1000);
    const SineCosine at = sine_cosine_deg(angle);
    ASSERT_NEAR(at.sine, std::sin(angle * std::numbers::pi / 180), 1e-13) << angle;
    ASSERT_NEAR(at.cosine, std::cos(angle * std::numbers::pi / 180), 1e-13) << angle;
  }
}

}  // namespace
}  // namespace kerf::control
