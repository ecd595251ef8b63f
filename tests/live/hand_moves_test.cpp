// Jog, reference return and the teach keys.
#include "bench.hpp"

namespace kerf::test {
namespace {

TEST(Jog, GoesAtItsSpeedUntilTheKeyIsLetGo) {
  Bench bench;
  EXPECT_REFUSED(bench->perform(Jog{"X", 600}), "in mode jog");
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_REFUSED(bench->perform(Jog{"Q", 600}), "no axis Q");
  EXPECT_REFUSED(bench->perform(Jog{"X", 0}), "speed");
  EXPECT_DONE(bench->perform(Jog{"X", 600}));
  EXPECT_REFUSED(bench->perform(Jog{"Y", 600}), "move already");
  bench->advance(2);
  EXPECT_NEAR(bench.now().feed_actual_mm_min, 600, 1e-3);
  EXPECT_DONE(bench->perform(JogStop{}));
  EXPECT_EQ(bench.settle(), Status::idle);
  EXPECT_NEAR(bench.x(), 20, 1);
  EXPECT_EQ(bench->snapshot()->work.values[0], bench.x());
}

TEST(Jog, ByADistanceEndsExactlyThere) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"X", 12.345, 600}));
  EXPECT_EQ(bench.settle(), Status::idle);
  EXPECT_EQ(bench.x(), 12.345);
  EXPECT_DONE(bench->perform(JogBy{"X", -2.345}));
  EXPECT_EQ(bench.settle(), Status::idle);
  EXPECT_NEAR(bench.x(), 10, 1e-12);
}

TEST(Jog, EndsAtTheEndOfTheTravelWithAnAlarm) {
  Bench bench;  // without stroke_check
  const auto& x = bench->definition().axes.axes[0];
  ASSERT_LT(x.travel_min, x.travel_max);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  for (const auto& [speed, limit, code] : {std::tuple(20000.0, x.travel_max, "OT0500"),
                                           std::tuple(-20000.0, x.travel_min, "OT0501")}) {
    EXPECT_DONE(bench->perform(Jog{"X", speed}));
    EXPECT_EQ(bench.settle(), Status::alarm);
    EXPECT_EQ(bench.x(), limit);
    ASSERT_TRUE(bench.now().alarm);
    EXPECT_EQ(bench.now().alarm->code, code);
    EXPECT_REFUSED(bench->perform(Jog{"X", speed}), "press reset");
    bench->perform(Reset{});
    EXPECT_DONE(bench->perform(Jog{"X", speed}));  // still there: nothing moves
    EXPECT_EQ(bench.status(), Status::alarm);
    EXPECT_EQ(bench.x(), limit);
    bench->perform(Reset{});
  }
}

TEST(Jog, OfALinkageEndsWhereItsJointsEnd) {
  for (const char* const name : {"arm4", "laser5", "laser-xtz"}) {
    Bench bench(name);
    EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
    EXPECT_DONE(bench->perform(Jog{"X", 6000}));
    const Status status = bench.settle();
    EXPECT_TRUE(status == Status::alarm) << name;
    const auto kinematics = bench->definition().make_kinematics();
    const base::JointPoint joints = bench.now().joints;
    const base::TipPoint tip = kinematics->forward(joints);
    for (std::size_t i = 0; i < bench->definition().axes.count(); ++i)
      EXPECT_NEAR(tip.values[i], bench.now().machine.values[i], 1e-6) << name;
    bench->perform(Reset{});
    EXPECT_DONE(bench->perform(JogBy{"X", -10, 600}));
    EXPECT_EQ(bench.settle(), Status::idle) << name;
  }
}

TEST(Jog, BetweenTwoBlocksTheProgramGoesOnFromWhereTheAxesAre) {
  Bench bench;
  bench.start("O1\nG90G00X10.\nM00\nG91X5.\nM30\n");
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"X", 20, 600}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 35);
}

TEST(Jog, IsRefusedWhileCompensationHoldsAMove) {
  Bench bench;
  bench.start("O1\nG10L12P1R5.\nG91G41D1G01X10.F600\nX10.\nM00\nX10.\nG40X10.\nM30\n");
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_REFUSED(bench->perform(Jog{"X", 600}), "compensation");
}

TEST(Jog, TheFeedDialIsTheJogDial) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(SetDials{50, 100, 100}));
  EXPECT_DONE(bench->perform(Jog{"X", 600}));
  bench->advance(2);
  EXPECT_NEAR(bench.now().feed_actual_mm_min, 300, 1e-3);
}

TEST(ReferenceReturn, BringsAllAxesHome) {
  Bench bench;
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"X", 12, 0}));
  bench.settle();
  EXPECT_REFUSED(bench->perform(Home{}), "in mode ref");
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  EXPECT_DONE(bench->perform(Home{}));
  EXPECT_EQ(bench.settle(), Status::idle);
  const auto& axes = bench->definition().axes;
  for (std::size_t i = 0; i < axes.count(); ++i)
    EXPECT_EQ(bench.now().machine.values[i], axes.axes[i].reference[0]) << i;
  EXPECT_DONE(bench->perform(Home{}));  // there already
  EXPECT_EQ(bench.status(), Status::idle);
}

TEST(TeachKeys, CapturedPointsMakeAProgramThatGoesThere) {
  Bench bench("laser5");
  EXPECT_FALSE(bench->capture(LiveMachine::Capture::point));
  EXPECT_DONE(bench->perform(SetMode{Mode::teach}));
  EXPECT_DONE(bench->perform(JogBy{"X", 20, 0}));
  EXPECT_FALSE(bench->capture(LiveMachine::Capture::point));  // it moves
  bench.settle();
  const auto point = bench->capture(LiveMachine::Capture::point, "edge");
  ASSERT_TRUE(point);
  ASSERT_TRUE(bench->teach_record("FEED 1200"));
  EXPECT_FALSE(bench->capture(LiveMachine::Capture::arc_end));  // without its middle
  EXPECT_DONE(bench->perform(JogBy{"Y", 30, 0}));
  bench.settle();
  ASSERT_TRUE(bench->capture(LiveMachine::Capture::line));
  const auto taught = bench->teach_record("END");
  ASSERT_TRUE(taught);
  EXPECT_NE(taught->text.find("edge"), std::string::npos);

  Bench other("laser5", {.dialect = "teach"});
  other.load(taught->text, "taught.tch");
  other.go_on_to_end();
  EXPECT_NEAR(other.now().machine.values[0], 20, 1e-6);
  EXPECT_NEAR(other.now().machine.values[1], 30, 1e-6);
}

}  // namespace
}  // namespace kerf::test
