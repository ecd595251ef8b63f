// Every motion says which block commands it, and which calls led there.
#include "base/block_id.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "control/core/call_paths.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::test {
namespace {

using base::BlockId;
using base::CallPath;
using control::CallPaths;

class Moves : public motion::MotionSink {
 public:
  void take(const motion::Motion& motion) override { list.push_back(motion); }
  std::vector<motion::Motion> list;
};

class Blocks : public ::testing::Test {
 protected:
  const std::vector<motion::Motion>& run(const std::string& program,
                                         const std::string& machine = "mill3",
                                         const std::string& file = "part.nc") {
    program_ = program;
    const machine::MachineDefinition definition = *machine::find_machine(machine);
    machine::Machine::Settings settings;
    if (file.ends_with(".bas")) settings.dialect = "laser-basic";
    if (file.ends_with(".tch")) settings.dialect = "teach";
    machine_.emplace(definition, control::Memory(definition.parameters.n_offsets), settings);
    machine_->add_sink(moves_);
    machine_->load(base::SourceFile::from_text(file, program));
    machine_->run_to_end();
    return moves_.list;
  }
  // The text of a block, cut from the program by its bytes.
  [[nodiscard]] std::string text(const BlockId& block) const {
    return program_.substr(block.from, block.length);
  }
  // Line and column are those of the first byte.
  void expect_placed(const BlockId& block) const {
    const std::string before = program_.substr(0, block.from);
    EXPECT_EQ(block.line, 1 + std::count(before.begin(), before.end(), '\n')) << text(block);
    EXPECT_EQ(block.column, before.size() - (before.rfind('\n') + 1) + 1) << text(block);
    EXPECT_GT(block.length, 0U);
    EXPECT_EQ(text(block).find('\n'), std::string::npos) << text(block);
  }
  // "M98 P2 > G65 P3": the blocks that called.
  [[nodiscard]] std::string callers(const motion::Motion& motion) {
    std::string list;
    for (const BlockId& by : machine_->control().calls(motion.block.calls)) {
      expect_placed(by);
      list += (list.empty() ? "" : " > ") + text(by);
    }
    return list;
  }

  std::optional<machine::BatchRun> machine_;
  Moves moves_;
  std::string program_;
};

TEST_F(Blocks, TwoOnOneLineAreTwo) {
  const auto& moves = run("O0007\nG90 G01 X1. F100; N20 X2. (second);X3.\nN30 Y4.\nM30\n");
  ASSERT_EQ(moves.size(), 5U);
  for (const motion::Motion& motion : moves) expect_placed(motion.block);
  EXPECT_EQ(text(moves[0].block), "G90 G01 X1. F100");
  EXPECT_NE(text(moves[1].block).find("N20 X2. (second)"), std::string::npos);
  EXPECT_EQ(text(moves[2].block), "X3.");
  EXPECT_EQ(moves[1].block.line, moves[2].block.line);
  EXPECT_NE(moves[1].block, moves[2].block);
  EXPECT_EQ(moves[0].block.sequence, 0U);
  EXPECT_EQ(moves[1].block.sequence, 20U);
  EXPECT_EQ(moves[2].block.sequence, 0U);
  EXPECT_EQ(moves[3].block.sequence, 30U);
  EXPECT_EQ(moves[4].block.program, base::ProgramNumber{7});
}

TEST_F(Blocks, CallsAreTheBlocksThatLedThere) {
  const auto& moves =
      run("O1\nG91\nM98 P2 L2; M98 P2\nG65 P3 X1.\nM30\n"
          "O2\nG00 X1.\nG65 P3 X5.\nM99\n"
          "O3\nG00 X#24\nM99\n");
  const std::vector<std::pair<unsigned, std::string>> wanted = {
      {2, "M98 P2 L2"},  {3, "M98 P2 L2 > G65 P3 X5."},
      {2, "M98 P2 L2"},  {3, "M98 P2 L2 > G65 P3 X5."},
      {2, " M98 P2"},    {3, " M98 P2 > G65 P3 X5."},
      {3, "G65 P3 X1."}, {1, ""}};
  ASSERT_EQ(moves.size(), wanted.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    EXPECT_EQ(static_cast<unsigned>(moves[i].block.program), wanted[i].first) << i;
    EXPECT_EQ(callers(moves[i]), wanted[i].second) << i;
  }
  EXPECT_EQ(moves[0].block, moves[2].block) << "the same block along the same calls";
  EXPECT_NE(moves[0].block, moves[4].block) << "along another call";
}

TEST_F(Blocks, StatementsOfTheLaserAreToldApart) {
  const auto& moves =
      run("SPEED(10)\nPOWER(50)\nGOSUB side; GOSUB side\nEND\n"
          "side: LINE(1, 0); IF 1 = 1 THEN LINE(2, 0) ELSE LINE(3, 0)\nRETURN\n",
          "laser3", "cut.bas");
  ASSERT_FALSE(machine_->alarm()) << machine_->alarm()->message;
  std::vector<std::string> cuts;
  for (const motion::Motion& motion : moves) {
    expect_placed(motion.block);
    if (std::holds_alternative<motion::Line>(motion.action))
      cuts.push_back(callers(motion) + ": " + text(motion.block));
  }
  EXPECT_EQ(cuts, (std::vector<std::string>{"GOSUB side: LINE(1, 0)", "GOSUB side: LINE(2, 0)",
                                            "GOSUB side: LINE(1, 0)", "GOSUB side: LINE(2, 0)"}));
}

TEST_F(Blocks, TaughtPointsAreToldByTheirRecords) {
  const auto& moves =
      run("TEACH 1\nFEED 1000\nPOINT 0 0 1 0 0\n  LINE 10 0 1 0 0\nEND\n", "laser5", "path.tch");
  ASSERT_FALSE(machine_->alarm()) << machine_->alarm()->message;
  ASSERT_FALSE(moves.empty());
  for (const motion::Motion& motion : moves) expect_placed(motion.block);
}

TEST_F(Blocks, AnAlarmSaysItsBlock) {
  run("O1\nM98 P2\nM30\nO2\nG01 X1. F100; N7 G01 X[1/0]\nM99\n");
  ASSERT_TRUE(machine_->alarm());
  const BlockId& block = machine_->alarm()->block;
  expect_placed(block);
  EXPECT_EQ(block.sequence, 7U);
  EXPECT_EQ(block.program, base::ProgramNumber{2});
  const auto by = machine_->control().calls(block.calls);
  ASSERT_EQ(by.size(), 1U);
  EXPECT_EQ(text(by[0]), "M98 P2");
}

TEST_F(Blocks, AMoveThatWaitedForTheNextIsRefusedAtItsOwn) {
  machine::MachineDefinition definition = *machine::find_machine("mill3");
  EXPECT_TRUE(definition.parameters.set("stroke_check", "1"));
  control::Memory memory(definition.parameters.n_offsets);
  memory.tools[1].radius_geometry = 5;
  machine_.emplace(definition, std::move(memory));
  program_ = "O1\nG90 G00 G41 D1 X10. Y10.\nG01 X99999. F1000\nY20.\nG40 X0\nM30\n";
  machine_->load(base::SourceFile::from_text("part.nc", program_));
  machine_->run_to_end();
  ASSERT_TRUE(machine_->alarm());
  EXPECT_EQ(machine_->alarm()->block.line, 3U) << machine_->alarm()->message;
}

TEST(CallPaths, OneBlockAlongOnePathIsOnePath) {
  CallPaths paths;
  const BlockId one{.line = 1, .column = 1, .from = 0};
  const BlockId other{.line = 1, .column = 9, .from = 8};
  const CallPath first = paths.behind(one);
  EXPECT_EQ(paths.behind(one), first);
  EXPECT_NE(paths.behind(other), first);
  BlockId inner = other;
  inner.calls = first;
  EXPECT_EQ(paths.calls(paths.behind(inner)), (std::vector<BlockId>{one, inner}));
  EXPECT_TRUE(paths.calls(CallPath::main).empty());
}

TEST(CallPaths, BeyondTheirNumberTheyAreUnknown) {
  CallPaths paths;
  for (std::uint64_t i = 0; i < CallPaths::kMost; ++i)
    ASSERT_NE(paths.behind({.line = 1, .from = i}), CallPath::unknown);
  BlockId late{.line = 2, .from = CallPaths::kMost};
  EXPECT_EQ(paths.behind(late), CallPath::unknown);
  EXPECT_NE(paths.behind({.line = 1, .from = 0}), CallPath::unknown);
  late.calls = CallPath::unknown;
  EXPECT_EQ(paths.behind(late), CallPath::unknown);
  EXPECT_TRUE(paths.calls(CallPath::unknown).empty());
}

}  // namespace
}  // namespace kerf::test
