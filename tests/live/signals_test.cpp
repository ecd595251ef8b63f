// What a program is told from outside while it runs: input signals, variables, the interrupt.
#include "bench.hpp"

namespace kerf::test {
namespace {

constexpr const char* kWaits = "O1\nG91G01X5.F600\nWHILE[#1003EQ0]DO1\nG04P100\nEND1\nX5.\nM30\n";

TEST(Inputs, AProgramThatWaitsForOneGoesOnWhenItIsGiven) {
  Bench bench;
  bench.start(kWaits, 3);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_EQ(bench.x(), 5);
  EXPECT_DONE(bench->perform(SetVariable{"#1003", 1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 10);
}

TEST(Inputs, AreGivenInFeedHoldToo) {
  Bench bench;
  bench.start(kWaits, 3);
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(0.2);
  EXPECT_EQ(bench.status(), Status::held);
  EXPECT_DONE(bench->perform(SetVariable{"#1003", 1}));
  bench->advance(1);
  EXPECT_EQ(bench.x(), 5);
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 10);
}

TEST(Inputs, AreReadWhenTheAxesHaveComeToTheBlock) {
  Bench bench;
  bench.start("O1\nG91G01X10.F600\nX10.\nIF[#1000EQ1]GOTO9\nY5.\nN9X10.\nM30\n", 1.9);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_DONE(bench->perform(SetInput{"#1000", 1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 30);
  EXPECT_EQ(bench.now().machine.values[1], 0);
}

TEST(Inputs, StayForTheProgramsThatFollow) {
  Bench bench;
  bench.load("O1\n#500=#1000\n#501=#1032\n#502=#1033\nM30\n");
  EXPECT_DONE(bench->perform(SetInput{"#1000", 1}));
  EXPECT_DONE(bench->perform(SetInput{"#1003", 1}));
  EXPECT_DONE(bench->perform(SetInput{"#1033", -2}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.value("#500"), 1);
  EXPECT_EQ(bench.value("#501"), 9);
  EXPECT_EQ(bench.value("#502"), -2);
  EXPECT_EQ(bench.now().inputs[0], 9U);
}

TEST(Inputs, ThatDoNotExistOrAreNoNumbersAreRefused) {
  Bench bench;
  bench.load("O1\nM30\n");
  EXPECT_REFUSED(bench->perform(SetInput{"#1016", 1}), "no such input");
  EXPECT_REFUSED(bench->perform(SetInput{"#1036", 1}), "#1000 to #1035");
  EXPECT_REFUSED(bench->perform(SetInput{"#100", 1}), "#1000 to #1035");
  EXPECT_REFUSED(bench->perform(SetInput{"#1033", 1e11}), "32 bits");
  Bench teach("laser5", {.dialect = "teach"});
  EXPECT_REFUSED(teach->perform(SetInput{"#1000", 1}), "no input of this program");
}

// The loop moves nothing and takes no time: only the journal knows how often it went round.
TEST(Inputs, ALoopWithoutAnyMotionEndsAndAnInstantFindsItsPasses) {
  Bench bench;
  bench.start(
      "O1\nG91G01X5.F600\n#500=0\nWHILE[#1003EQ0]DO1\n#500=#500+1\nEND1\nX5.\nG04X1.\nM30\n");
  for (int i = 0; i < 40; ++i) bench->advance(0.05);
  EXPECT_EQ(bench.status(), Status::running);
  EXPECT_DONE(bench->perform(SetInput{"#1003", 1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 10);
  const double passes = bench.value("#500");
  EXPECT_GT(passes, 1000);
  ASSERT_TRUE(bench->state_at(bench.now().time_s - 0.5));
  double found = 0;
  for (const auto& row : bench->variables_at_state().rows) {
    if (row.name == "#500") found = row.value;
  }
  EXPECT_EQ(found, passes);
}

TEST(Inputs, AnInstantBeforeTheSignalIsInTheLoop) {
  Bench bench;
  bench.start(kWaits, 2);
  EXPECT_DONE(bench->perform(SetInput{"#1003", 1}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ((*bench->state_at(1.5))->line, 4U);
  EXPECT_EQ((*bench->state_at(1.5))->inputs[0], 0U);
  EXPECT_EQ((*bench->state_at(2.5))->line, 6U);
  EXPECT_EQ((*bench->state_at(2.5))->inputs[0], 8U);
}

// Four cuts; the control has read them all while the first one is made.
constexpr const char* kCuts = "O1\n#100=1\nG91G61G01X10.F600\nX[#100]\n#100=3\nX[#100]\nM30\n";

TEST(VariablesUnderWay, AreSetInFeedHoldAndActOnTheNextBlock) {
  Bench bench;
  bench.start(kCuts, 0.5);
  EXPECT_REFUSED(bench->perform(SetVariable{"#100", 7}), "while nothing moves");
  bench.hold();
  const double held = bench.x();
  EXPECT_DONE(bench->perform(SetVariable{"#100", 7}));
  EXPECT_EQ(bench.status(), Status::held);
  EXPECT_EQ(bench.x(), held);
  EXPECT_REFUSED(bench->perform(SetVariable{"#4711", 7}), "#4711");
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 20);  // 10 + 7 + 3: what the program sets later counts then
}

TEST(VariablesUnderWay, AreSetInADwell) {
  Bench bench;
  bench.start("O1\n#100=1\nG91G01X5.F600\nG04X2.\nX[#100]\nM30\n", 1.5);
  EXPECT_DONE(bench->perform(SetVariable{"#100", 7}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 12);
}

TEST(VariablesUnderWay, OfTheLevelThatIsShown) {
  Bench bench;
  bench.start("O1\nG65P2A1.\nG91G01X100.F6000\nM30\nO2\nG91G61G01X10.F600\nX#1\nM99\n", 0.5);
  bench.hold();
  EXPECT_DONE(bench->perform(SetVariable{"#1", 5}));
  bench.go_on_to_end();
  EXPECT_EQ(bench.x(), 115);
}

constexpr const char* kInterruptible =
    "O1\nM96P2\nG91G61G01X10.F600\nX10.\nX10.\nM97\nX10.\nM30\nO2\n#500=#500+1\nG91G01Y2.\nM99\n";

TEST(Interrupt, RunsItsProgramBehindTheBlockThatTheAxesAreIn) {
  Bench bench;
  bench.load(kInterruptible);
  EXPECT_REFUSED(bench->perform(Interrupt{}), "no program under way");
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(1.5);
  EXPECT_DONE(bench->perform(Interrupt{}));
  while (bench.now().machine.values[1] < 1) bench->advance(0.01);
  EXPECT_EQ(bench.x(), 20);
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.x(), 40);
  EXPECT_EQ(bench.now().machine.values[1], 2);
  EXPECT_EQ(bench.value("#500"), 1);
  EXPECT_EQ((*bench->state_at(1.5))->machine.values[1], 0);
  EXPECT_EQ((*bench->state_at(3.5))->machine.values[1], 2);
}

TEST(Interrupt, ThatMeetsNoM96IsTold) {
  Bench bench;
  bench.start(kInterruptible, 3.5);  // behind M97
  EXPECT_DONE(bench->perform(Interrupt{}));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.now().machine.values[1], 0);
  ASSERT_FALSE(bench.now().messages.empty());
  EXPECT_NE(bench.now().messages.back().find("no M96 was in force"), std::string::npos);
}

}  // namespace
}  // namespace kerf::test
