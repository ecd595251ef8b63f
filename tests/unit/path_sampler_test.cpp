#include "motion/path_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "allocation_count.hpp"
#include "geometry/angle.hpp"
#include "geometry/arc.hpp"
#include "motion_axes.hpp"
#include "space_arc_cases.hpp"

namespace kerf::motion {
namespace {

using base::AxisVector;
using control::Arc;
using control::Direction;
using control::Dwell;
using control::FeedMode;
using control::Line;
using control::Motion;
using control::Rapid;
using test::axes_named;
using Points = std::vector<Setpoint>;

constexpr double kPrinted = 5.001e-7;  // six decimals
constexpr double kPeriod_s = 0.008;

Settings settings_of(Sampling sampling, double step_mm = 1) {
  Settings settings;
  settings.sampling = sampling;
  settings.period_s = kPeriod_s;
  settings.step_mm = step_mm;
  return settings;
}

Points sample(const std::vector<Motion::Action>& actions, const Settings& settings,
              const char* letters = "XYZAC", double rapid_per_min = 10'000) {
  PathSampler sampler(axes_named(letters, rapid_per_min), settings);
  return test::points_of(sampler, test::motions_of(actions));
}

// A rapid to `from`, and what comes behind it.
Points sample_from(const AxisVector& from, const Motion::Action& action, const Settings& settings) {
  Points points = sample({Rapid{from}, action}, settings);
  std::erase_if(points, [](const Setpoint& point) { return point.mark.line == 1; });
  return points;
}

void expect_near(const AxisVector& got, const AxisVector& wanted, const std::string& what) {
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    EXPECT_NEAR(got.values[m], wanted.values[m], kPrinted) << what << ", axis " << m;
}

void expect_rows(const Points& points, const std::vector<AxisVector>& rows) {
  ASSERT_EQ(points.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    expect_near(points[i].tip, rows[i], "point " + std::to_string(i + 1));
}

// Lines at steps of 1 mm.

const std::vector<AxisVector> kFiveSteps = {
    {{2.6, 1.8}}, {{3.2, 2.6}}, {{3.8, 3.4}}, {{4.4, 4.2}}, {{5, 5}}};

TEST(PathSampler, ALineOfWholeStepsHasNoPointTwice) {
  expect_rows(sample_from({{2, 1}}, Line{{{5, 5}}, {600}}, settings_of(Sampling::equal_steps)),
              kFiveSteps);
}

const std::vector<AxisVector> kSlanted = {{{0.957826, 0, -0.287348}},
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

const std::vector<AxisVector> kStaircase = {{{1, 0, -1}}, {{2, 0, -2}}, {{3, 0, -3}}, {{4, 0, -3}},
                                            {{5, 0, -3}}, {{6, 0, -3}}, {{7, 0, -3}}, {{8, 0, -3}},
                                            {{9, 0, -3}}, {{10, 0, -3}}};

TEST(PathSampler, LiterallyTheHeightStepsByItself) {
  expect_rows(sample({Line{{{10, 0, -3}}, {600}}}, settings_of(Sampling::literal)), kStaircase);
}

// Arcs at steps of 1 mm.

const std::vector<AxisVector> kQuarter = {
    {{9.950042, 0.998334}}, {{9.800666, 1.986693}}, {{9.553365, 2.955202}}, {{9.210610, 3.894183}},
    {{8.775826, 4.794255}}, {{8.253356, 5.646425}}, {{7.648422, 6.442177}}, {{6.967067, 7.173561}},
    {{6.216100, 7.833269}}, {{5.403023, 8.414710}}, {{4.535961, 8.912074}}, {{3.623578, 9.320391}},
    {{2.674988, 9.635582}}, {{1.699671, 9.854497}}, {{0.707372, 9.974950}}, {{0, 10}}};

struct ArcCase {
  const char* name;
  Direction direction;
  AxisVector from, to;
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

// A line of five axes at a constant feed: 114.564392 mm at 0.4 mm a period of 8 ms.

struct NumberedRow {
  std::size_t number;
  AxisVector tip;
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
  AxisVector tip;
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
    for (const Setpoint& point : points) EXPECT_LE(arc.distance_mm(point.tip), 3e-6) << arc.name;
  }
}

// Two seconds for all of it, not for each part between the points given.
TEST(PathSampler, InInverseTimeAnArcInSpaceTakesWhatItsFeedSays) {
  control::SpaceArc arc = test::kSpaceArcs[1].arc(0);
  arc.feed = {30, FeedMode::inverse_time};
  const Points points = sample_from(test::kSpaceArcs[1].from, arc, settings_of(Sampling::equal));
  EXPECT_EQ(points.size(), 250U);
}

// What is neither line nor arc at feed.

TEST(PathSampler, RapidsGoAsFastAsTheSlowestAxisNeeds) {
  control::AxisSetup axes = axes_named("XYA");
  axes.axes[0].rapid_per_min = 6000;   // 100 mm/s
  axes.axes[1].rapid_per_min = 12000;  // 200 mm/s
  axes.axes[2].rapid_per_min = 600;    // 10 degrees/s
  const struct {
    AxisVector to;
    double seconds;
  } rapids[] = {{{{100}}, 1}, {{{100, 300}}, 1.5}, {{{100, 300, 20}}, 2}};
  for (const Sampling sampling : {Sampling::tail, Sampling::equal}) {
    for (const auto& rapid : rapids) {
      PathSampler sampler(axes, settings_of(sampling));
      const Points points = test::points_of(sampler, test::motions_of({Rapid{rapid.to}}));
      EXPECT_EQ(points.size(), std::ceil(rapid.seconds / kPeriod_s - 1e-9));
      EXPECT_EQ(points.back().tip, rapid.to);
      EXPECT_EQ(points.back().mark.kind, MoveKind::rapid);
    }
  }
}

// 90 degrees at 10 000 degrees/min are 0.54 s, whatever the feed.
TEST(PathSampler, RotaryAxesAloneTurnAtTheirRateInEqualSteps) {
  const AxisVector to{{0, 0, 0, 30, -90}};
  for (const Sampling sampling : {Sampling::tail, Sampling::equal}) {
    const Points points = sample({Line{to, {100}}}, settings_of(sampling));
    ASSERT_EQ(points.size(), 68U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = static_cast<double>(i + 1) / 68;
      EXPECT_NEAR(points[i].tip.values[3], 30 * share, 1e-12);
      EXPECT_NEAR(points[i].tip.values[4], -90 * share, 1e-12);
    }
    EXPECT_EQ(points.back().tip, to);
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

TEST(PathSampler, AMoveWhoseFeedCannotBeToldIsAsFastAsARapid) {
  const Points told = sample({Rapid{{{100}}}}, settings_of(Sampling::equal));
  const Points untold =
      sample({Line{{{100}}, {0.1, FeedMode::per_revolution}}}, settings_of(Sampling::equal));
  ASSERT_EQ(told.size(), untold.size());
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(told[i].tip, untold[i].tip);
}

TEST(PathSampler, FeedPerRevolutionIsThatOfTheSpindle) {
  using control::Spindle;
  const Points points = sample({Spindle{Spindle::Turning::clockwise, Spindle::Mode::rpm, 600, 0},
                                Line{{{10}}, {0.5, FeedMode::per_revolution}}},
                               settings_of(Sampling::equal));
  EXPECT_EQ(points.size(), 250U) << "10 mm at 5 mm/s";
}

TEST(PathSampler, ADwellLastsWholePeriods) {
  const Points points =
      sample({Line{{{1}}, {7500}}, Dwell{0.03}, Line{{{2}}, {7500}}}, settings_of(Sampling::tail));
  ASSERT_EQ(points.size(), 6U);
  for (std::size_t i = 1; i <= 4; ++i) {
    EXPECT_EQ(points[i].tip, (AxisVector{{1}}));
    EXPECT_EQ(points[i].mark.kind, MoveKind::dwell);
    EXPECT_EQ(points[i].mark.line, 2U);
  }
  EXPECT_EQ(points[5].tip, (AxisVector{{2}}));
}

TEST(PathSampler, WithoutAPeriodADwellIsAPointAtItsEnd) {
  const Points points = sample({Line{{{1}}, {60}}, Dwell{0.03}, Line{{{2}}, {60}}},
                               settings_of(Sampling::equal_steps));
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR(points[1].time_s, 1.03, 1e-12);
  EXPECT_EQ(points[1].tip, points[0].tip);
  EXPECT_NEAR(points[2].time_s, 2.03, 1e-12);
}

TEST(PathSampler, EveryPeriodHasAPoint) {
  const Points points =
      sample({Rapid{{{7, 3}}}, kFiveAxes, Dwell{0.1}, kArcs[0].arc()}, settings_of(Sampling::tail));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i].time_s, static_cast<double>(i + 1) * kPeriod_s);
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

TEST(PathSampler, AWayOfNoLengthHasNoPoints) {
  for (const Sampling sampling :
       {Sampling::tail, Sampling::equal, Sampling::equal_steps, Sampling::literal}) {
    EXPECT_TRUE(sample({Line{{}, {100}}, Rapid{}, Dwell{0}}, settings_of(sampling)).empty());
    EXPECT_EQ(sample({Line{{{0.001}}, {100}}}, settings_of(sampling)).size(), 1U);
  }
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

// Any number of motions.

std::vector<Motion> many_motions(int count) {
  std::vector<Motion::Action> actions;
  for (int i = 0; i < count; ++i) {
    const double x = i;
    actions.push_back(Rapid{{{x, 1}}});
    actions.push_back(Line{{{x + 10, 1}}, {60000}});
    actions.push_back(Arc{.to = {{x + 10, 3}}, .center = {x + 10, 2}, .feed = {30000}});
    actions.push_back(Dwell{0.01});
  }
  return test::motions_of(actions);
}

TEST(PathSampler, PassingOverThePointsKeepsTheTime) {
  const std::vector<Motion> motions = many_motions(2000);
  for (const Sampling sampling : {Sampling::tail, Sampling::equal_steps}) {
    PathSampler made(axes_named("XYZ"), settings_of(sampling));
    const Points points = test::points_of(made, motions);
    PathSampler passed(axes_named("XYZ"), settings_of(sampling));
    test::pass_over(passed, motions);
    EXPECT_EQ(passed.time_s(), made.time_s());
    EXPECT_EQ(points.back().time_s, made.time_s());
  }
}

TEST(PathSampler, AllocatesNothingOnTheWay) {
  const std::vector<Motion> motions = many_motions(2000);
  PathSampler sampler(axes_named("XYZ"), settings_of(Sampling::tail));
  Setpoint point;
  std::uint64_t points = 0;
  const auto drive = [&](const Motion& motion) {
    sampler.take(motion);
    while (sampler.next(point)) ++points;
  };
  for (std::size_t i = 0; i < 4; ++i) drive(motions[i]);  // one of each kind
  const std::uint64_t before = test::allocations_so_far();
  for (const Motion& motion : motions) drive(motion);
  EXPECT_EQ(test::allocations_so_far(), before);
  EXPECT_GT(points, 10'000U);
}

}  // namespace
}  // namespace kerf::motion
