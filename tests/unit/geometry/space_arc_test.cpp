#include "geometry/space_arc.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "geometry/angle.hpp"
#include "seeded_random.hpp"

namespace kerf::geometry {
namespace {

using test::kSeed;
using test::SeededRandom;

constexpr int kCases = 100'000;
constexpr double kFull = 2 * std::numbers::pi;
constexpr double kPrinted = 5e-7;  // six decimals

std::string text(Vec3 p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) + ")";
}

void expect_near(Vec3 got, Vec3 wanted, double tolerance, const std::string& what) {
  EXPECT_LE(length(got - wanted), tolerance)
      << what << ": " << text(got) << ", wanted " << text(wanted);
}

struct Points {
  Vec3 p1, p2, p3;
};

std::string text(const Points& p) { return text(p.p1) + " " + text(p.p2) + " " + text(p.p3); }

std::optional<NoArc> why(const tl::expected<SpaceArc, NoArc>& found) {
  return found ? std::nullopt : std::optional(found.error());
}

SpaceArc arc_of(const Points& p) { return SpaceArc::through(p.p1, p.p2, p.p3).value(); }
SpaceArc circle_of(const Points& p) { return SpaceArc::circle(p.p1, p.p2, p.p3).value(); }

// Worked from the bisecting planes of the chords in exact fractions; printed with six decimals.
struct Worked {
  const char* name;
  Points points;
  Vec3 centre;
  double radius;
  Vec3 e1, e2, e3;
  double to_second_deg, second_to_third_deg, total_deg;
};

constexpr Worked kWorked[] = {
    {"half circle",
     {{40, 0, 0}, {0, 40, 0}, {-40, 0, 0}},
     {0, 0, 0},
     40,
     {1, 0, 0},
     {0, 1, 0},
     {0, 0, 1},
     90,
     90,
     180},
    {"oblique",
     {{10, 0, 0}, {0, 10, 5}, {-6, -2, 12}},
     {1.793713, 0.090373, 5.906680},
     10.111388,
     {0.811589, -0.008938, -0.584161},
     {-0.096439, 0.984117, -0.149042},
     {0.576215, 0.177297, 0.797836},
     95.759337,
     96.887023,
     192.646361},
    {"three quarters clockwise",
     {{10, 0, 0}, {0, -10, 0}, {0, 10, 0}},
     {0, 0, 0},
     10,
     {1, 0, 0},
     {0, -1, 0},
     {0, 0, -1},
     90,
     180,
     270},
    {"upright",
     {{0, 0, 0}, {30, 0, 40}, {60, 0, 0}},
     {30, 0, 8.75},
     31.25,
     {-0.96, 0, -0.28},
     {-0.28, 0, 0.96},
     {0, 1, 0},
     106.260205,
     106.260205,
     212.520409},
    {"clockwise from behind",
     {{50, 20, 10}, {55, 25, 10}, {60, 20, 10}},
     {55, 20, 10},
     5,
     {-1, 0, 0},
     {0, 1, 0},
     {0, 0, -1},
     90,
     90,
     180},
};

TEST(SpaceArc, HasTheFrameAndTheAnglesOfWorkedExamples) {
  for (const Worked& wanted : kWorked) {
    const SpaceArc arc = arc_of(wanted.points);
    expect_near(arc.centre(), wanted.centre, 2 * kPrinted, wanted.name);
    EXPECT_NEAR(arc.radius(), wanted.radius, kPrinted) << wanted.name;
    expect_near(arc.e1(), wanted.e1, 2 * kPrinted, wanted.name);
    expect_near(arc.e2(), wanted.e2, 2 * kPrinted, wanted.name);
    expect_near(arc.e3(), wanted.e3, 2 * kPrinted, wanted.name);
    EXPECT_NEAR(degrees(arc.to_second_rad()), wanted.to_second_deg, kPrinted) << wanted.name;
    EXPECT_NEAR(degrees(arc.to_third_rad() - arc.to_second_rad()), wanted.second_to_third_deg,
                kPrinted)
        << wanted.name;
    EXPECT_NEAR(degrees(arc.sweep_rad()), wanted.total_deg, kPrinted) << wanted.name;
  }
}

TEST(SpaceArc, PointsThatCarryNoneAreTold) {
  const Vec3 a{1, 2, 3};
  const Vec3 b{4, 6, 8};
  const Vec3 middle{2.5, 4, 5.5};
  EXPECT_EQ(why(SpaceArc::through(a, middle, b)), NoArc::straight);
  EXPECT_EQ(why(SpaceArc::through(middle, a, b)), NoArc::collinear);
  EXPECT_EQ(why(SpaceArc::through(a, b, middle)), NoArc::collinear);
  EXPECT_EQ(why(SpaceArc::through(a, a, b)), NoArc::coincident);
  EXPECT_EQ(why(SpaceArc::through(a, b, b)), NoArc::coincident);
  EXPECT_EQ(why(SpaceArc::through(a, b, a)), NoArc::coincident);
  EXPECT_EQ(why(SpaceArc::through(a, {1, 2, 3 + 0.9e-6}, b)), NoArc::coincident);
}

TEST(SpaceArc, ACircleThroughPointsOfALineIsNone) {
  EXPECT_EQ(why(SpaceArc::circle({0, 0, 0}, {1, 1, 1}, {2, 2, 2})), NoArc::collinear);
  EXPECT_EQ(why(SpaceArc::circle({1, 1, 1}, {0, 0, 0}, {2, 2, 2})), NoArc::collinear);
  EXPECT_EQ(why(SpaceArc::circle({0, 0, 0}, {1, 1, 1}, {0, 0, 0})), NoArc::coincident);
}

TEST(SpaceArc, PointsLieOnALineWhenTheyLeaveItByLessThanABillionth) {
  const Vec3 p1{0, 0, 0};
  const Vec3 p3{100, 0, 0};
  EXPECT_EQ(why(SpaceArc::through(p1, {50, 0.9e-7, 0}, p3)), NoArc::straight);
  EXPECT_EQ(why(SpaceArc::through(p1, {50, 1.1e-7, 0}, p3)), std::nullopt);
}

// Of sizes from a thousandth to kilometres, and no sharper than a hundredth of a degree.
Points random_points(SeededRandom& random) {
  for (;;) {
    const double size = random.size(0.01, 1e6);
    const auto point = [&] {
      return Vec3{random.in(-size, size), random.in(-size, size), random.in(-size, size)};
    };
    const Points points{point(), point(), point()};
    const Vec3 u = points.p2 - points.p1;
    const Vec3 v = points.p3 - points.p1;
    const double reach = std::max(length(u), length(v));
    if (length(cross(u, v)) > 1e-4 * reach * reach) return points;
  }
}

double size_of(const SpaceArc& arc) { return std::max(1.0, arc.radius()); }

TEST(SpaceArc, FrameIsOrthonormalAndItsThirdAxisNormalToTheArms) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc arc = arc_of(points);
    const std::array<Vec3, 3> frame{arc.e1(), arc.e2(), arc.e3()};
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(length(frame[k]), 1, 1e-12) << text(points);
      ASSERT_NEAR(dot(frame[k], frame[(k + 1) % 3]), 0, 1e-12) << text(points);
    }
    ASSERT_LE(length(cross(frame[0], frame[1]) - frame[2]), 1e-12) << text(points);
    for (const Vec3 p : {points.p1, points.p2, points.p3})
      ASSERT_NEAR(dot(arc.e3(), p - arc.centre()), 0, 1e-9 * size_of(arc)) << text(points);
  }
}

TEST(SpaceArc, EveryPointLiesOnTheCircleAndTheEndsAreExact) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc arc = arc_of(points);
    const double tolerance = 1e-9 * size_of(arc);
    const Vec3 p = arc.at(random.in(0, arc.sweep_rad()));
    ASSERT_NEAR(length(p - arc.centre()), arc.radius(), tolerance) << text(points);
    ASSERT_NEAR(dot(arc.e3(), p - arc.centre()), 0, tolerance) << text(points);
    ASSERT_LE(length(arc.at(arc.to_second_rad()) - points.p2), tolerance) << text(points);
    ASSERT_EQ(arc.at(0), points.p1);
    ASSERT_EQ(arc.at(arc.sweep_rad()), points.p3);
    ASSERT_EQ(arc.at(-1), points.p1);
    ASSERT_EQ(arc.at(7), points.p3);
  }
}

TEST(SpaceArc, ComesToTheSecondPointBeforeTheThird) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc arc = arc_of(points);
    ASSERT_GT(arc.to_second_rad(), 0) << text(points);
    ASSERT_GT(arc.to_third_rad(), arc.to_second_rad()) << text(points);
    ASSERT_LT(arc.to_third_rad(), kFull) << text(points);
    const auto angle = [&](Vec3 p) {
      const double a = std::atan2(dot(p - arc.centre(), arc.e2()), dot(p - arc.centre(), arc.e1()));
      return a < 0 ? a + kFull : a;
    };
    ASSERT_NEAR(arc.to_second_rad(), angle(points.p2), 1e-8) << text(points);
    ASSERT_NEAR(arc.to_third_rad(), angle(points.p3), 1e-8) << text(points);
  }
}

TEST(SpaceArc, ReversedItHasTheSameCentreAndItsAnglesSwapped) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc arc = arc_of(points);
    const SpaceArc back = arc_of({points.p3, points.p2, points.p1});
    ASSERT_LE(length(back.centre() - arc.centre()), 1e-9 * size_of(arc)) << text(points);
    ASSERT_LE(length(back.e3() + arc.e3()), 1e-9) << text(points);
    ASSERT_NEAR(back.to_second_rad(), arc.to_third_rad() - arc.to_second_rad(), 1e-12);
    ASSERT_NEAR(back.to_third_rad(), arc.to_third_rad(), 1e-12) << text(points);
  }
}

// A turn about a random axis by Rodrigues' formula, then a shift.
struct RigidMotion {
  Vec3 axis;
  double angle_rad;
  Vec3 shift;
  [[nodiscard]] Vec3 turned(Vec3 p) const {
    const double c = std::cos(angle_rad);
    return c * p + std::sin(angle_rad) * cross(axis, p) + ((1 - c) * dot(axis, p)) * axis;
  }
  [[nodiscard]] Vec3 moved(Vec3 p) const { return turned(p) + shift; }
};

RigidMotion random_motion(SeededRandom& random, double most_shift) {
  const auto any = [&](double most) {
    return Vec3{random.in(-most, most), random.in(-most, most), random.in(-most, most)};
  };
  return {unit(any(1)), random.in(-4, 4), any(most_shift)};
}

TEST(SpaceArc, ARigidMotionOfItsPointsMovesItRigidly) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc arc = arc_of(points);
    const RigidMotion by = random_motion(random, arc.radius());
    const SpaceArc moved = arc_of({by.moved(points.p1), by.moved(points.p2), by.moved(points.p3)});
    const double tolerance = 1e-9 * size_of(arc);
    const double angle = random.in(0, arc.sweep_rad());
    ASSERT_LE(length(moved.at(angle) - by.moved(arc.at(angle))), tolerance) << text(points);
    ASSERT_LE(length(moved.centre() - by.moved(arc.centre())), tolerance) << text(points);
    ASSERT_LE(length(moved.e3() - by.turned(arc.e3())), 1e-9) << text(points);
    ASSERT_NEAR(moved.radius(), arc.radius(), tolerance) << text(points);
  }
}

TEST(SpaceArc, TangentIsTheSlopeOfTheWay) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const SpaceArc arc = arc_of(random_points(random));
    const double angle = random.in(0.01, 0.99) * arc.sweep_rad();
    constexpr double kStep = 1e-5;
    const Vec3 slope =
        (0.5 / kStep / arc.radius()) * (arc.at(angle + kStep) - arc.at(angle - kStep));
    ASSERT_LE(length(slope - arc.tangent(angle)), 1e-7);
  }
}

TEST(SpaceArc, NoPointOfTheCircleLiesFarther) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const Points points = random_points(random);
    const SpaceArc circle = circle_of(points);
    const Vec3 direction = random_motion(random, 1).axis;
    const double angle = circle.farthest_rad(direction);
    ASSERT_GE(angle, 0);
    ASSERT_LT(angle, kFull);
    const double farthest = dot(direction, circle.at(angle));
    for (int k = 0; k < 360; ++k) {
      const Vec3 p = circle.at(radians(k));
      ASSERT_LE(dot(direction, p), farthest + 1e-9 * size_of(circle)) << text(points);
    }
  }
}

TEST(SpaceArc, AFlatArcKeepsItsDigits) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 1000; ++i) {
    const double rise = random.size(1e-6, 1);
    const Points points{{0, 0, 0}, {random.in(20, 80), rise, 0}, {100, 0, 0}};
    const SpaceArc arc = arc_of(points);
    ASSERT_LE(length(arc.at(arc.to_second_rad()) - points.p2), 1e-10) << rise;
    ASSERT_LE(length(arc.at(arc.sweep_rad() * (1 - 1e-12)) - points.p3), 1e-9) << rise;
  }
}

TEST(SpaceArc, ACircleGoesOnToWhereItBegan) {
  SeededRandom random(kSeed);
  for (int i = 0; i < kCases; ++i) {
    const Points points = random_points(random);
    const SpaceArc circle = circle_of(points);
    const double tolerance = 1e-9 * size_of(circle);
    ASSERT_EQ(circle.sweep_rad(), kFull);
    ASSERT_EQ(circle.at(0), points.p1);
    ASSERT_EQ(circle.at(kFull), points.p1);
    ASSERT_LE(length(circle.at(circle.to_second_rad()) - points.p2), tolerance) << text(points);
    ASSERT_LE(length(circle.at(circle.to_third_rad()) - points.p3), tolerance) << text(points);
  }
}

}  // namespace
}  // namespace kerf::geometry
