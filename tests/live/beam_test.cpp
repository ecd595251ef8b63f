// The beam of a laser at the panel: holds, moves by hand, dials.
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "bench.hpp"

namespace kerf::test {
namespace {

TEST(Beam, IsOffWhileTheFeedIsHeld) {
  Bench bench("laser3");
  bench.load("speed(10); power(50)\nline(40,0)\nend\n", "a.bas", "laser-basic");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(1);
  EXPECT_TRUE(bench.now().beam);
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(1);
  EXPECT_EQ(bench.status(), Status::held);
  EXPECT_FALSE(bench.now().beam);
  EXPECT_EQ(bench.now().power_percent, 50);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(1);
  EXPECT_TRUE(bench.now().beam);
}

// By hand the axes move without the beam, whatever an entry or a broken-off program has left.
TEST(Beam, IsOffWhileAnAxisIsJogged) {
  for (const char* const left :
       {"M03 S500\nG91 G01 X10. F600", "M03 S500\nG91 G01 X10. F600\nX[1/0]"}) {
    Bench bench("laser3");
    EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
    EXPECT_DONE(bench->perform(EnterBlocks{left}));
    bench->advance(0.5);
    EXPECT_TRUE(bench.now().beam);
    bench.settle();
    EXPECT_FALSE(bench.now().beam);
    bench->perform(Reset{});
    EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
    Points points;
    bench->add_point_sink(points);
    EXPECT_DONE(bench->perform(JogBy{"X", 2, 600}));
    bench->advance(0.1);
    EXPECT_FALSE(bench.now().beam) << left;
    bench.settle();
    ASSERT_FALSE(points.all.empty());
    for (const auto& point : points.all) EXPECT_EQ(point.power_percent, 0) << left;
  }
}

TEST(Beam, IsOffOnTheWayToTheReferencePoint) {
  Bench bench("laser3");
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"M03 S500\nG91 G01 X10. F600"}));
  bench.settle();
  EXPECT_EQ(bench.x(), 10);
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->perform(Home{}));
  bench.settle();
  EXPECT_EQ(bench.x(), 0);
  ASSERT_FALSE(points.all.empty());
  for (const auto& point : points.all) EXPECT_EQ(point.power_percent, 0);
}

TEST(Beam, OfM04FollowsTheFeedDialUpToFullPower) {
  for (const auto& [dial, power] : {std::pair{50, 40.0F}, {100, 80.0F}, {150, 100.0F}}) {
    Bench bench("laser3");
    bench.load("O1\nM04S800\nG01X60.F600\nM30\n");
    EXPECT_DONE(bench->perform(SetDials{dial, 100, 100}));
    Points points;
    bench->add_point_sink(points);
    bench.go_on_to_end();
    float most = 0;
    for (const auto& point : points.all) most = std::max(most, point.power_percent);
    EXPECT_EQ(most, power) << dial;
    EXPECT_EQ(points.all[points.all.size() / 2].power_percent, power) << dial;
  }
}

TEST(Beam, HasTheSpindleDialForItsPower) {
  const std::string constant = "O1\nM03S600\nG01X60.F600\nM30\n";
  const std::string follows = "O1\nM04S600\nG01X60.F600\nM30\n";
  const std::string full = "O1\nM03S900\nG01X60.F600\nM30\n";
  for (const auto& [text, dial, power] : {std::tuple{constant, 50, 30.0F},
                                          {follows, 50, 30.0F},
                                          {constant, 120, 72.0F},
                                          {follows, 120, 72.0F},
                                          {full, 120, 100.0F}}) {
    Bench bench("laser3");
    bench.load(text);
    EXPECT_DONE(bench->perform(SetDials{100, 100, dial}));
    Points points;
    bench->add_point_sink(points);
    EXPECT_DONE(bench->perform(CycleStart{}));
    bench->advance(3);
    EXPECT_EQ(bench.now().power_percent, power) << text << dial;
    EXPECT_EQ(bench.settle(), Status::end);
    EXPECT_EQ(points.all[points.all.size() / 2].power_percent, power) << text << dial;
  }
}

TEST(Beam, IsThatOfTheProgramBehindAJog) {
  Bench bench("laser3");
  bench.load("speed(10); power(50)\nline(10,0)\nline(20,0)\nline(30,0)\nend\n", "a.bas",
             "laser-basic");
  bench->perform(TurnSwitch{Switch::single_block, true});
  for (int statement = 0; statement < 3; ++statement) {
    EXPECT_DONE(bench->perform(CycleStart{}));
    bench.settle();
  }
  EXPECT_EQ(bench.x(), 10);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"X", 2, 600}));
  bench.settle();
  EXPECT_EQ(bench.x(), 12);
  EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
  bench->perform(TurnSwitch{Switch::single_block, false});
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.5);
  EXPECT_TRUE(bench.now().beam);
  EXPECT_EQ(bench.settle(), Status::end);
  ASSERT_FALSE(points.all.empty());
  for (const auto& point : points.all) EXPECT_EQ(point.power_percent, 50) << point.tip.time_s;
}

}  // namespace
}  // namespace kerf::test
