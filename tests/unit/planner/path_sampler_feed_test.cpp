#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "planner/path_samples.hpp"
#include "space_arc_cases.hpp"

namespace kerf::planner {
namespace {

using namespace samples;
using motion::FeedMode;
using motion::Line;

// A line of five axes at a constant feed: 114.564392 mm at 0.4 mm a period of 8 ms.

struct NumberedRow {
  std::size_t number;
  TipPoint tip;
};

const Line kFiveAxes{{{100, 50, 25, 30, 90}}, {3000}};

TEST(PathSampler, TheLastStepOfALineIsWhatRemains) {
  const NumberedRow rows[] = {
      {1, {{0.349149, 0.174574, 0.087287, 0.104745, 0.314234}}},
      {2, {{0.698297, 0.349149, 0.174574, 0.209489, 0.628468}}},
      {100, {{34.914862, 17.457431, 8.728716, 10.474459, 31.423376}}},
      {200, {{69.829725, 34.914862, 17.457431, 20.948917, 62.846752}}},
      {286, {{99.856507, 49.928253, 24.964127, 29.956952, 89.870856}}},
      {287, {{100, 50, 25, 30, 90}}},
  };
  const Points points = sample({kFiveAxes}, settings_of(Sampling::tail));
  ASSERT_EQ(points.size(), 287U);
  for (const NumberedRow& row : rows)
    expect_near(points[row.number - 1].tip, row.tip, std::to_string(row.number));
  const AxisVector last = points[286].tip - points[285].tip;
  EXPECT_NEAR(std::hypot(last.values[0], last.values[1], last.values[2]), 0.164392374, 5e-10);
}

TEST(PathSampler, AllStepsOfALineAreEqual) {
  const NumberedRow rows[] = {
      {1, {{0.348432, 0.174216, 0.087108, 0.104530, 0.313589}}},
      {100, {{34.843206, 17.421603, 8.710801, 10.452962, 31.358885}}},
      {286, {{99.651568, 49.825784, 24.912892, 29.895470, 89.686411}}},
      {287, {{100, 50, 25, 30, 90}}},
  };
  const Points points = sample({kFiveAxes}, settings_of(Sampling::equal));
  ASSERT_EQ(points.size(), 287U);
  for (const NumberedRow& row : rows)
    expect_near(points[row.number - 1].tip, row.tip, std::to_string(row.number));
  const AxisVector step = points[0].tip;
  EXPECT_NEAR(std::hypot(step.values[0], step.values[1], step.values[2]), 0.399179068, 5e-10);
}

// Arcs in space at a constant feed.

struct SpaceArcRow {
  std::size_t arc;
  std::size_t number;
  TipPoint tip;
};

struct SpaceArcFeed {
  double feed_mm_min;
  std::size_t points;
};
constexpr SpaceArcFeed kSpaceArcFeeds[] = {
    {3000, 315}, {3000, 85}, {6000, 59}, {3000, 290}, {1500, 79}};

const SpaceArcRow kSpaceArcRows[] = {
    {0, 1, {{39.998000, 0.399993, 0, 0.063662, 0.286479}}},
    {0, 78, {{28.436542, 28.131177, 0, 4.965634, 22.345354}}},
    {0, 157, {{0.031853, 39.999987, 0, 9.994930, 44.977187}}},
    {0, 314, {{-39.999949, 0.063706, 0, 29.979722, 89.954374}}},
    {0, 315, {{-40, 0, 0, 30, 90}}},
    {1, 1, {{9.955014, 0.393615, -0.054980, 5.355044, 0.710088}}},
    {1, 21, {{6.607343, 7.377441, 0.810821, 12.455920, 14.911840}}},
    {1, 42, {{0.079326, 10.008447, 4.940832, 19.911840, 29.823681}}},
    {1, 84, {{-6.102022, -1.615858, 11.988318, -9.302290, 49.534860}}},
    {1, 85, {{-6, -2, 12, -10, 50}}},
    {2, 1, {{9.968017, -0.799147, 0, 0.763944, -1.527887}}},
    {2, 14, {{4.356824, -9.001004, 0, 10.695212, -21.390424}}},
    {2, 29, {{-6.810559, -7.322314, 0, 18.577184, -8.536896}}},
    {2, 58, {{-0.723258, 9.973811, 0, 29.654368, 57.926208}}},
    {2, 59, {{0, 10, 0, 30, 60}}},
    {3, 1, {{-0.109539, 0, 0.384706, 0.138036, -0.069018}}},
    {3, 72, {{4.893621, 0, 27.357316, 9.938582, -4.969291}}},
    {3, 145, {{30.044049, 0, 39.999969, 19.988599, -10.022801}}},
    {3, 289, {{60.085837, 0, 0.299857, 5.080726, -39.838549}}},
    {3, 290, {{60, 0, 0, 5, -40}}},
    {4, 1, {{50.003999, 20.199947, 10, 39.872676, 170.509296}}},
    {4, 19, {{51.375820, 23.444607, 10, 37.580845, 179.676621}}},
    {4, 39, {{54.946019, 24.999709, 10, 35.034366, 189.862537}}},
    {4, 78, {{59.998834, 20.107955, 10, 20.206195, 199.862537}}},
    {4, 79, {{60, 20, 10, 20, 200}}},
};

TEST(PathSampler, ArcsInSpacePassThePointsOfTheTable) {
  std::vector<Points> sampled;
  for (std::size_t i = 0; i < test::kSpaceArcs.size(); ++i) {
    const test::SpaceArcCase& arc = test::kSpaceArcs[i];
    sampled.push_back(
        sample_from(arc.from, arc.arc(kSpaceArcFeeds[i].feed_mm_min), settings_of(Sampling::tail)));
    EXPECT_EQ(sampled.back().size(), kSpaceArcFeeds[i].points) << arc.name;
    EXPECT_EQ(sampled.back().back().tip, arc.to) << arc.name;
  }
  for (const SpaceArcRow& row : kSpaceArcRows) {
    ASSERT_LE(row.number, sampled[row.arc].size());
    expect_near(sampled[row.arc][row.number - 1].tip, row.tip,
                std::string(test::kSpaceArcs[row.arc].name) + " " + std::to_string(row.number));
  }
}

TEST(PathSampler, AFullCircleInSpaceIsOneMotion) {
  for (const test::SpaceArcCase& arc : test::kSpaceArcs) {
    const Points points = sample_from(arc.from, arc.circle(3000), settings_of(Sampling::equal));
    const double steps = 2 * std::numbers::pi * arc.radius / 0.4;
    EXPECT_EQ(points.size(), static_cast<std::size_t>(std::ceil(steps))) << arc.name;
    EXPECT_EQ(points.back().tip, arc.from) << arc.name;
    for (const motion::Setpoint& point : points)
      EXPECT_LE(arc.distance_mm(point.tip), 3e-6) << arc.name;
  }
}

// Two seconds for all of it, not for each part between the points given.
TEST(PathSampler, InInverseTimeAnArcInSpaceTakesWhatItsFeedSays) {
  motion::SpaceArc arc = test::kSpaceArcs[1].arc(0);
  arc.feed = {30, FeedMode::inverse_time};
  const Points points = sample_from(test::kSpaceArcs[1].from, arc, settings_of(Sampling::equal));
  EXPECT_EQ(points.size(), 250U);
}

}  // namespace
}  // namespace kerf::planner
