// Optional stop and block skip act when the axes come to the block, however far the control has
// read ahead.
#include <random>

#include "bench.hpp"

namespace kerf::test {
namespace {

constexpr const char* kStopAhead = "O1\nG21G90G94G01X10.F600\nX20.\nX30.\nM01\nX40.\nM30\n";

TEST(OptionalStop, SwitchedOnUnderWayStops) {
  Bench bench;
  bench.start(kStopAhead, 0.3);
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, true}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.x(), 30);
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 40);
}

TEST(OptionalStop, SwitchedOffUnderWayDoesNotStop) {
  Bench bench;
  bench.load(kStopAhead);
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, true}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.3);
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, false}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 40);
}

constexpr std::uint32_t kLevel1 = 1U << 1U;

// In G61 the axes rest behind each block, so each slash can be decided at the last moment.
std::string with_slashes(const char* mode, int blocks) {
  std::string text = std::string("O1\nG21G91G94") + mode + "G01X10.F600\n";
  for (int i = 0; i < blocks; ++i) text += "/Y1.\nX10.\n";
  return text + "M30\n";
}

TEST(BlockSkip, SwitchedUnderWayActsOnTheSlashesThatTheAxesHaveNotBegun) {
  for (const char* const mode : {"G61", "G64"}) {
    Bench bench;
    Points points;
    bench->add_point_sink(points);
    bench.start(with_slashes(mode, 3), 0.5);
    EXPECT_DONE(bench->perform(SetBlockSkip{kLevel1}));
    EXPECT_EQ(bench.now().panel.skip_levels, kLevel1);
    bench->advance(1.2);  // in the second X10. now
    EXPECT_EQ(bench.now().machine.values[1], 0) << mode;
    EXPECT_EQ(bench.line(), 4U);
    EXPECT_DONE(bench->perform(SetBlockSkip{0}));
    EXPECT_EQ(bench.settle(), Status::end);
    EXPECT_EQ(bench.now().machine.values[1], 2) << mode;
    EXPECT_EQ(bench.x(), 40);
    EXPECT_EQ(points.starts.size(), 2U);  // at power-on and at cycle start: the axes never jump
  }
}

TEST(BlockSkip, AnInstantAndAStepBackKnowWhatWasSwitchedWhen) {
  Bench bench;
  bench.start(with_slashes("G61", 3), 0.5);
  EXPECT_DONE(bench->perform(SetBlockSkip{kLevel1}));
  bench->advance(1.2);
  EXPECT_DONE(bench->perform(SetBlockSkip{0}));
  EXPECT_EQ(bench.settle(), Status::end);
  const auto levels_at = [&](double time_s) {
    const auto then = bench->state_at(time_s);
    return then ? (*then)->panel.skip_levels : 99;
  };
  EXPECT_EQ(levels_at(0.4), 0U);
  EXPECT_EQ(levels_at(0.6), kLevel1);
  EXPECT_EQ(levels_at(2), 0U);
  EXPECT_EQ((*bench->state_at(1.5))->machine.values[1], 0);
  EXPECT_EQ((*bench->state_at(bench.now().time_s))->machine.values[1], 2);
  // Back before the second switching: the slash is skipped again.
  std::vector<std::uint32_t> lines;
  while (bench->perform(StepBack{}) && bench.line() > 2) lines.push_back(bench.line());
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{9, 8, 7, 6, 5, 4, 3}));
  EXPECT_EQ(bench.now().panel.skip_levels, 0U);
}

TEST(BlockSkip, WhereTheAxesCannotTurnOffAnyMoreTheNextSlashIsMeant) {
  Bench bench;
  bench.start(
      "O1\nG21G91G94G64G01X10.F6000\n/X10.\nX10.\n/Y7.\nX0.1\nX10.\nX10.\nX10.\nX10.\nM30\n");
  while (bench.x() < 9.9) bench->advance(0.001);
  EXPECT_LT(bench.x(), 10);
  EXPECT_GT(bench.now().feed_actual_mm_min, 3000);
  EXPECT_DONE(bench->perform(SetBlockSkip{kLevel1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.now().machine.values[1], 0);
}

TEST(BlockSkip, AThousandTinyBlocksAheadDoNotMatter) {
  Bench bench;
  std::string text = "O1\nG21G91G94G64G01X1.F3000\n";
  for (int i = 0; i < 2000; ++i) text += "/X0.05\n";
  bench.start(text + "Y1.\nM30\n");
  while (bench.x() < 10) bench->advance(0.01);
  const double at = bench.x();
  EXPECT_DONE(bench->perform(SetBlockSkip{kLevel1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_GT(bench.x(), at);
  EXPECT_LT(bench.x(), at + 3);  // it must brake from 50 mm/s
}

TEST(BlockSkip, OfAProgramWithoutSlashesIsOnlyASwitch) {
  Bench bench;
  bench.start("O1\nG91G01X10.F600\nX10.\nM30\n", 0.5);
  EXPECT_DONE(bench->perform(SetBlockSkip{kLevel1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 20);
}

/// What a person at the panel switches, and when.
struct Switching {
  double time_s = 0;
  bool on = false;
};

// A row of blocks: X10., which takes 1 s and something, /Y1., M01. Every block ends in a
// standstill.
constexpr int kRows = 12;
std::string rows() {
  std::string text = "O1\nG21G91G94G61\n";
  for (int i = 0; i < kRows; ++i) text += "G01X10.F600\n/G04P20\nM01\n";
  return text + "M30\n";
}

/// Sees in which rows the dwell behind the slash was made.
class Slashes : public motion::AxisPointSink {
 public:
  void start(const motion::AxisPoint& /*at*/) override {}
  void take(const motion::AxisPoint& point) override {
    const std::uint32_t line = point.tip.mark.block.line;
    if (line < 3) return;
    if (line % 3 == 0 && arrived.size() < line / 3) arrived.push_back(point.tip.time_s);
    if (line % 3 == 0) arrived[line / 3 - 1] = point.tip.time_s;
    if (line % 3 == 1) made.at(line / 3 - 1) = true;
  }
  std::vector<double> arrived;  // at the end of X10., each row
  std::vector<bool> made = std::vector<bool>(kRows);
};

// The oracle knows nothing of reading ahead: what counts is how a switch stands at the instant at
// which the axes come to the block.
TEST(RandomSwitching, EachSlashAndEachOptionalStopObeysTheSwitchOfItsInstant) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> pause_s(0.01, 1.5);
    Bench bench;
    Slashes seen;
    bench->add_point_sink(seen);
    bench.start(rows());
    std::vector<Switching> skips{{-1, false}};
    std::vector<Switching> stops{{-1, false}};
    std::vector<double> stopped_at;
    for (double until_s = pause_s(random); bench.status() == Status::running;) {
      bench->advance(0.004);
      const double now = bench.now().time_s;
      if (bench.status() == Status::stopped) {
        stopped_at.push_back(now);
        EXPECT_DONE(bench->perform(CycleStart{}));
      }
      if (now < until_s) continue;
      until_s = now + pause_s(random);
      const bool of_skip = random() % 2 == 0;
      auto& list = of_skip ? skips : stops;
      list.push_back({now, !list.back().on});
      if (of_skip) {
        EXPECT_DONE(bench->perform(SetBlockSkip{list.back().on ? kLevel1 : 0}));
      } else {
        EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, list.back().on}));
      }
    }
    EXPECT_EQ(bench.status(), Status::end);
    const auto on_at = [](const std::vector<Switching>& list, double time_s) {
      bool on = false;
      for (const Switching& each : list) {
        if (each.time_s < time_s) on = each.on;
      }
      return on;
    };
    ASSERT_EQ(seen.arrived.size(), kRows);
    std::vector<double> expected_stops;
    for (std::size_t row = 0; row < kRows; ++row) {
      const double at_slash = seen.arrived[row];
      EXPECT_EQ(seen.made[row], !on_at(skips, at_slash)) << "row " << row << " at " << at_slash;
      const double at_stop = at_slash + (seen.made[row] ? 0.02 : 0);
      if (on_at(stops, at_stop)) expected_stops.push_back(at_stop);
    }
    ASSERT_EQ(stopped_at.size(), expected_stops.size());
    for (std::size_t i = 0; i < stopped_at.size(); ++i)
      EXPECT_NEAR(stopped_at[i], expected_stops[i], 1e-9);
  }
}

}  // namespace
}  // namespace kerf::test
