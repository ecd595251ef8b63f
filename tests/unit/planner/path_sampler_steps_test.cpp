#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geometry/angle.hpp"
#include "geometry/arc.hpp"
#include "planner/path_samples.hpp"

namespace kerf::planner {
namespace {

using namespace samples;
using motion::Arc;
using motion::Direction;
using motion::Dwell;
using motion::Line;

// Lines at steps of 1 mm.

const std::vector<TipPoint> kFiveSteps = {
    {{2.6, 1.8}}, {{3.2, 2.6}}, {{3.8, 3.4}}, {{4.4, 4.2}}, {{5, 5}}};

TEST(PathSampler, ALineOfWholeStepsHasNoPointTwice) {
  expect_rows(sample_from({{2, 1}}, Line{{{5, 5}}, {600}}, settings_of(Sampling::equal_steps)),
              kFiveSteps);
}

const std::vector<TipPoint> kSlanted = {{{0.957826, 0, -0.287348}},
                                        {{1.915653, 0, -0.574696}},
                                        {{2.873479, 0, -0.862044}},
                                        {{3.831305, 0, -1.149392}},
                                        {{4.789131, 0, -1.436739}},
                                        {{5.746958, 0, -1.724087}},
                                        {{6.704784, 0, -2.011435}},
                                        {{7.662610, 0, -2.298783}},
                                        {{8.620437, 0, -2.586131}},
                                        {{9.578263, 0, -2.873479}},
                                        {{10, 0, -3}}};

TEST(PathSampler, StepsOfASlantedLineCountAllAxes) {
  expect_rows(sample({Line{{{10, 0, -3}}, {600}}}, settings_of(Sampling::equal_steps)), kSlanted);
}

const std::vector<TipPoint> kStaircase = {{{1, 0, -1}}, {{2, 0, -2}}, {{3, 0, -3}}, {{4, 0, -3}},
                                          {{5, 0, -3}}, {{6, 0, -3}}, {{7, 0, -3}}, {{8, 0, -3}},
                                          {{9, 0, -3}}, {{10, 0, -3}}};

TEST(PathSampler, LiterallyTheHeightStepsByItself) {
  expect_rows(sample({Line{{{10, 0, -3}}, {600}}}, settings_of(Sampling::literal)), kStaircase);
}

// Arcs at steps of 1 mm.

const std::vector<TipPoint> kQuarter = {
    {{9.950042, 0.998334}}, {{9.800666, 1.986693}}, {{9.553365, 2.955202}}, {{9.210610, 3.894183}},
    {{8.775826, 4.794255}}, {{8.253356, 5.646425}}, {{7.648422, 6.442177}}, {{6.967067, 7.173561}},
    {{6.216100, 7.833269}}, {{5.403023, 8.414710}}, {{4.535961, 8.912074}}, {{3.623578, 9.320391}},
    {{2.674988, 9.635582}}, {{1.699671, 9.854497}}, {{0.707372, 9.974950}}, {{0, 10}}};

struct ArcCase {
  const char* name;
  Direction direction;
  TipPoint from, to;
  std::array<double, 2> to_centre;
  double radius, begin_deg, sweep_deg, step_deg, length_mm;
  std::size_t points;
  AxisVector first;

  [[nodiscard]] Arc arc(double feed = 600) const {
    return {.to = to,
            .center = {from.values[0] + to_centre[0], from.values[1] + to_centre[1]},
            .feed = {feed},
            .direction = direction};
  }
};

constexpr auto kLeft = Direction::counterclockwise;
constexpr auto kRight = Direction::clockwise;

// The sixth one ends at another radius than it begins.
const ArcCase kArcs[] = {
    {"quarter",
     kLeft,
     {{10, 0, 0}},
     {{0, 10, 0}},
     {-10, 0},
     10,
     0,
     90,
     5.729578,
     15.707963,
     16,
     {{9.950042, 0.998334, 0}}},
    {"three quarters",
     kRight,
     {{10, 0, 0}},
     {{0, 10, 0}},
     {-10, 0},
     10,
     0,
     270,
     5.729578,
     47.123890,
     48,
     {{9.950042, -0.998334, 0}}},
    {"full circle",
     kRight,
     {{5, 0, 0}},
     {{5, 0, 0}},
     {-5, 0},
     5,
     0,
     360,
     11.459156,
     31.415927,
     32,
     {{4.900333, -0.993347, 0}}},
    {"helix",
     kLeft,
     {{10, 0, 0}},
     {{-10, 0, -4}},
     {-10, 0},
     10,
     0,
     180,
     5.729578,
     31.415927,
     32,
     {{9.950042, 0.998334, -0.127324}}},
    {"from the top",
     kRight,
     {{3, 7, 0}},
     {{8, 2, 0}},
     {0, -5},
     5,
     90,
     90,
     11.459156,
     7.853982,
     8,
     {{3.993347, 6.900333, 0}}},
    {"spiral",
     kLeft,
     {{20, 5, 0}},
     {{12, 9, 0}},
     {-8, -1},
     8.062258,
     7.125016,
     82.874984,
     7.106667,
     11.661583,
     12,
     {{19.560289, 5.917496, 0}}},
    {"tiny of a huge circle",
     kRight,
     {{0, 0, 0}},
     {{0.002, 0, 0}},
     {0.001, -2000},
     2000,
     90.000029,
     0.000057,
     0.028648,
     0.002,
     1,
     {{0.002, 0, 0}}},
};

TEST(PathSampler, AQuarterOfACirclePointByPoint) {
  expect_rows(sample_from(kArcs[0].from, kArcs[0].arc(), settings_of(Sampling::equal_steps)),
              kQuarter);
}

TEST(PathSampler, StepsOfArcsAreThoseOfTheTable) {
  for (const ArcCase& row : kArcs) {
    const geometry::Vec2 from{row.from.values[0], row.from.values[1]};
    const geometry::Vec2 to{row.to.values[0], row.to.values[1]};
    const geometry::Vec2 centre{from.u + row.to_centre[0], from.v + row.to_centre[1]};
    const double radius = geometry::length(from - centre);
    const double sweep = geometry::sweep_rad(from, to, centre, row.direction == kRight);
    EXPECT_NEAR(radius, row.radius, kPrinted) << row.name;
    EXPECT_NEAR(geometry::heading_deg(centre, from), row.begin_deg, kPrinted) << row.name;
    EXPECT_NEAR(geometry::degrees(sweep), row.sweep_deg, kPrinted) << row.name;
    EXPECT_NEAR(geometry::degrees(1 / radius), row.step_deg, kPrinted) << row.name;
    EXPECT_NEAR(radius * sweep, row.length_mm, kPrinted) << row.name;
    const Points points = sample_from(row.from, row.arc(), settings_of(Sampling::equal_steps));
    ASSERT_EQ(points.size(), row.points) << row.name;
    expect_near(points.front().tip, row.first, row.name);
    EXPECT_EQ(points.back().tip, row.to) << row.name;
  }
}

TEST(PathSampler, AtEqualStepsRotaryAxesAloneStepDegrees) {
  const Points points =
      sample({Line{{{0, 0, 0, 25}}, {600}}}, settings_of(Sampling::equal_steps, 10));
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0].tip.values[3], 10);
  EXPECT_EQ(points[1].tip.values[3], 20);
  EXPECT_EQ(points[2].tip.values[3], 25);
  EXPECT_NEAR(points[2].time_s, 2.5, 1e-12);
}

TEST(PathSampler, WithoutAPeriodADwellIsAPointAtItsEnd) {
  const Points points =
      sample({Line{{1}, {60}}, Dwell{0.03}, Line{{2}, {60}}}, settings_of(Sampling::equal_steps));
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR(points[1].time_s, 1.03, 1e-12);
  EXPECT_EQ(points[1].tip, points[0].tip);
  EXPECT_NEAR(points[2].time_s, 2.03, 1e-12);
}

TEST(PathSampler, AtEqualStepsTheTimeIsThePathOverTheFeed) {
  for (const Sampling sampling : {Sampling::equal_steps, Sampling::literal}) {
    const Points points = sample({Line{{{10, 0, -3}}, {600}}}, settings_of(sampling));
    EXPECT_NEAR(points.back().time_s, std::hypot(10, 3) / 10, 1e-12);
  }
  const Points points = sample({Line{{{10, 0, -3}}, {600}}}, settings_of(Sampling::equal_steps));
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    EXPECT_NEAR(points[i].time_s, static_cast<double>(i + 1) / 10, 1e-12);
}

// Literal mode.

TEST(PathSampler, LiterallyEachChainWaitsAtItsEnd) {
  const Points points = sample({Line{{{1.5, 2, -4.5, 9}}, {600}}}, settings_of(Sampling::literal));
  expect_rows(points, {{{0.6, 0.8, -1, 1.8}},
                       {{1.2, 1.6, -2, 3.6}},
                       {{1.5, 2, -3, 5.4}},
                       {{1.5, 2, -4, 7.2}},
                       {{1.5, 2, -4.5, 9}}});
}

TEST(PathSampler, LiterallyRapidsArcsAndTurnsStepAsOnes) {
  const std::vector<Motion::Action> actions = {Rapid{{{10, 0, -3}}}, kArcs[3].arc(),
                                               Line{{{-10, 0, -4, 0, 50}}, {600}}};
  const Points literal = sample(actions, settings_of(Sampling::literal));
  const Points others = sample(actions, settings_of(Sampling::equal_steps));
  ASSERT_EQ(literal.size(), others.size());
  for (std::size_t i = 0; i < literal.size(); ++i) EXPECT_EQ(literal[i].tip, others[i].tip);
}

}  // namespace
}  // namespace kerf::planner
