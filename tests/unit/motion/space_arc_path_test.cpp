#include "motion/space_arc_path.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "seeded_random.hpp"
#include "space_arc_cases.hpp"

namespace kerf::control {
namespace {

using base::AxisVector;
using base::TipPoint;
using test::kSeed;
using test::kSpaceArcs;
using test::SeededRandom;
using test::SpaceArcCase;

const motion::AxisSetup kAxes = test::five_axes();

motion::SpaceArcPath path_of(const SpaceArcCase& arc) { return {kAxes, arc.from, arc.arc(3000)}; }
motion::SpaceArcPath circle_of(const SpaceArcCase& arc) {
  return {kAxes, arc.from, arc.circle(3000)};
}

// The tip after `steps` steps of `step_mm` along the arc; the last one ends the arc.
struct Row {
  std::size_t arc;
  double step_mm;
  int steps;
  TipPoint tip;
};

const Row kRows[] = {
    {0, 0.4, 1, {{39.998000, 0.399993, 0, 0.063662, 0.286479}}},
    {0, 0.4, 78, {{28.436542, 28.131177, 0, 4.965634, 22.345354}}},
    {0, 0.4, 157, {{0.031853, 39.999987, 0, 9.994930, 44.977187}}},
    {0, 0.4, 314, {{-39.999949, 0.063706, 0, 29.979722, 89.954374}}},
    {0, 0.4, 315, {{-40, 0, 0, 30, 90}}},
    {1, 0.4, 1, {{9.955014, 0.393615, -0.054980, 5.355044, 0.710088}}},
    {1, 0.4, 21, {{6.607343, 7.377441, 0.810821, 12.455920, 14.911840}}},
    {1, 0.4, 42, {{0.079326, 10.008447, 4.940832, 19.911840, 29.823681}}},
    {1, 0.4, 84, {{-6.102022, -1.615858, 11.988318, -9.302290, 49.534860}}},
    {1, 0.4, 85, {{-6, -2, 12, -10, 50}}},
    {2, 0.8, 1, {{9.968017, -0.799147, 0, 0.763944, -1.527887}}},
    {2, 0.8, 14, {{4.356824, -9.001004, 0, 10.695212, -21.390424}}},
    {2, 0.8, 29, {{-6.810559, -7.322314, 0, 18.577184, -8.536896}}},
    {2, 0.8, 58, {{-0.723258, 9.973811, 0, 29.654368, 57.926208}}},
    {2, 0.8, 59, {{0, 10, 0, 30, 60}}},
    {3, 0.4, 1, {{-0.109539, 0, 0.384706, 0.138036, -0.069018}}},
    {3, 0.4, 72, {{4.893621, 0, 27.357316, 9.938582, -4.969291}}},
    {3, 0.4, 145, {{30.044049, 0, 39.999969, 19.988599, -10.022801}}},
    {3, 0.4, 289, {{60.085837, 0, 0.299857, 5.080726, -39.838549}}},
    {3, 0.4, 290, {{60, 0, 0, 5, -40}}},
    {4, 0.2, 1, {{50.003999, 20.199947, 10, 39.872676, 170.509296}}},
    {4, 0.2, 19, {{51.375820, 23.444607, 10, 37.580845, 179.676621}}},
    {4, 0.2, 39, {{54.946019, 24.999709, 10, 35.034366, 189.862537}}},
    {4, 0.2, 78, {{59.998834, 20.107955, 10, 20.206195, 199.862537}}},
    {4, 0.2, 79, {{60, 20, 10, 20, 200}}},
};

TEST(SpaceArcPath, PassesThePointsOfWorkedExamples) {
  for (const Row& row : kRows) {
    const motion::SpaceArcPath path = path_of(kSpaceArcs[row.arc]);
    const TipPoint tip = path.at(row.steps * row.step_mm / path.circle().radius());
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(tip.values[i], row.tip.values[i], 6e-7)
          << kSpaceArcs[row.arc].name << ", step " << row.steps << ", axis " << i;
    }
  }
}

TEST(SpaceArcPath, PassesThePointsGivenExactly) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const motion::SpaceArcPath path = path_of(arc);
    ASSERT_EQ(path.knots().size(), 3U);
    EXPECT_EQ(path.at(0), arc.from) << arc.name;
    EXPECT_EQ(path.at(path.circle().to_second_rad()), arc.via) << arc.name;
    EXPECT_EQ(path.at(path.circle().sweep_rad()), arc.to) << arc.name;
    EXPECT_EQ(path.at(-1), arc.from) << arc.name;
    EXPECT_EQ(path.at(7), arc.to) << arc.name;
  }
}

TEST(SpaceArcPath, AFullCirclePassesBothPointsAndEndsWhereItBegan) {
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const motion::SpaceArcPath path = circle_of(arc);
    ASSERT_EQ(path.knots().size(), 4U);
    EXPECT_EQ(path.at(path.circle().to_second_rad()), arc.via) << arc.name;
    EXPECT_EQ(path.at(path.circle().to_third_rad()), arc.to) << arc.name;
    EXPECT_EQ(path.at(2 * std::numbers::pi), arc.from) << arc.name;
    EXPECT_EQ(path.circle().sweep_rad(), 2 * std::numbers::pi);
  }
}

// Falling, equal and turning rotary axes as well: between two knots each one's share is the
// angle's.
TEST(SpaceArcPath, OtherAxesGoInProportionToTheAngle) {
  SeededRandom random(kSeed);
  for (int i = 0; i < 10'000; ++i) {
    SpaceArcCase arc = kSpaceArcs[static_cast<std::size_t>(random.count(0, 4))];
    for (TipPoint* const point : {&arc.from, &arc.via, &arc.to})
      point->values[3] = 10.0 * random.count(-2, 2);
    const motion::SpaceArcPath path = circle_of(arc);
    const double angle = random.in(0, path.circle().sweep_rad());
    const auto knots = path.knots();
    std::size_t next = 1;
    while (knots[next].angle_rad < angle) ++next;
    const double whole = knots[next].angle_rad - knots[next - 1].angle_rad;
    const double share = (angle - knots[next - 1].angle_rad) / whole;
    const double a = std::lerp(knots[next - 1].point.values[3], knots[next].point.values[3], share);
    ASSERT_NEAR(path.at(angle).values[3], a, 1e-12) << arc.name << " at " << angle;
    ASSERT_LE(arc.distance_mm(path.at(angle)), 2e-6) << arc.name << " at " << angle;
  }
}

TEST(SpaceArcPath, ChordsAreEqualBetweenTheKnotsAndNoneIsTooLong) {
  constexpr double kMost_rad = 0.1;
  for (const SpaceArcCase& arc : kSpaceArcs) {
    const motion::SpaceArcPath path = circle_of(arc);
    std::vector<TipPoint> ends{arc.from};
    path.chords(kMost_rad, [&](const TipPoint& end) { ends.push_back(end); });
    const double most_mm = 2 * arc.radius * std::sin(kMost_rad / 2) + 1e-6;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const AxisVector way = ends[i] - ends[i - 1];
      EXPECT_LE(std::hypot(way.values[0], way.values[1], way.values[2]), most_mm) << arc.name;
    }
    for (const auto& knot : path.knots())
      EXPECT_NE(std::find(ends.begin(), ends.end(), knot.point), ends.end()) << arc.name;
    EXPECT_LE(ends.size(), 2 * std::numbers::pi / kMost_rad + 5) << arc.name;
  }
}

TEST(SpaceArcPath, FindsItsAxesByTheirLetters) {
  motion::AxisSetup axes;
  for (const char letter : {'C', 'Z', 'X', 'Y'}) axes.axes.push_back({.letter = letter});
  const motion::SpaceArcPath path(axes, {{0, 7, 10, 0}},
                                  {.to = {{90, 7, -10, 0}}, .via = {{30, 7, 0, 10}}, .feed = {}});
  const TipPoint tip = path.at(std::numbers::pi / 4);
  EXPECT_NEAR(tip.values[0], 15, 1e-12);
  EXPECT_NEAR(tip.values[1], 7, 1e-12);
  EXPECT_NEAR(tip.values[2], 10 * std::numbers::sqrt2 / 2, 1e-12);
  EXPECT_NEAR(tip.values[3], 10 * std::numbers::sqrt2 / 2, 1e-12);
}

}  // namespace
}  // namespace kerf::control
