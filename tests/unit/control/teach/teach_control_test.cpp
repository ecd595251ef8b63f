#include <gtest/gtest.h>

#include "machine/run/batch_run.hpp"
#include "observer.hpp"

namespace kerf::test {
namespace {

using machine::BatchRun;
using Status = machine::RunStatus;

constexpr const char* kProgram =
    "TEACH 1\nRADII 150 80\nPOINT 10 0 0 0 0 start\nFEED 600\nLASER ON 50\n"
    "ARC 0 10 0 5 5  -10 0 0 0 0\n; round\nCIRCLE 0 10 0 5 5  10 0 0 9 9\nARC 0 0 0 1 1 10 0 0 2 "
    "2\n"
    "DWELL 0.5\nEND\n";

/// A machine on its panel.
struct Panel {
  explicit Panel(const std::string& text)
      : machine(*machine::find_machine("laser5"), control::Memory(1), {.dialect = "teach"}),
        recorder(machine.definition().axes) {
    machine.add_sink(recorder);
    machine.load(base::SourceFile::from_text("folder/part.v2.tch", text));
  }
  [[nodiscard]] std::vector<std::string> done() const {
    std::vector<std::string> list;
    for (const Observed& item : recorder.observed()) list.push_back(item.text);
    return list;
  }

  BatchRun machine;
  Recorder recorder;
};

TEST(TeachControl, StopsBehindEachRecordInSingleBlock) {
  Panel panel(kProgram);
  panel.machine.control().set_single_block(true);
  std::vector<std::uint32_t> lines;
  while (panel.machine.cycle_start() == Status::running)
    lines.push_back(panel.machine.control().standing_at().line);
  EXPECT_EQ(panel.machine.status(), Status::end);
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 8, 9, 10}));
  EXPECT_EQ(panel.machine.control().blocks(), 10U);
  Panel straight(kProgram);
  EXPECT_EQ(straight.machine.run_to_end(), Status::end);
  EXPECT_EQ(panel.done(), straight.done());
}

TEST(TeachControl, TellsEachLineOnceItBegins) {
  Panel panel(kProgram);
  std::vector<std::uint32_t> lines;
  panel.machine.observe_blocks([&](base::FileId, std::uint32_t line) { lines.push_back(line); });
  EXPECT_EQ(panel.machine.run_to_end(), Status::end);
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 8, 9, 10, 11}));
}

TEST(TeachControl, RunsAgainBehindItsEndAndBehindAnAlarm) {
  Panel panel(kProgram);
  EXPECT_EQ(panel.machine.run_to_end(), Status::end);
  const auto once = panel.done();
  EXPECT_EQ(panel.machine.run_to_end(), Status::end);
  const auto twice = panel.done();
  ASSERT_EQ(twice.size(), 2 * once.size());
  EXPECT_TRUE(std::equal(once.begin(), once.end(), twice.begin() + std::ssize(once)));

  Panel wrong(std::string("TEACH 1\nFEED 5\nPOINT 900 0 0 0 0\nEND\n"));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(wrong.machine.run_to_end(), Status::alarm);
    EXPECT_EQ(wrong.machine.alarm()->place.line, 3U);
    EXPECT_EQ(wrong.machine.alarm()->program, "O0000");
    EXPECT_EQ(wrong.done(), std::vector<std::string>{});
    wrong.machine.reset();
    EXPECT_FALSE(wrong.machine.alarm());
  }
}

TEST(TeachControl, ForgetsFeedAndPowerAtReset) {
  Panel panel("TEACH 1\nPOINT 1 0 0 0 0\nLASER ON 30\nEND\n");
  EXPECT_EQ(panel.machine.run_to_end(), Status::end);
  EXPECT_EQ(panel.done(),
            (std::vector<std::string>{"rapid X1 Y0 Z0 A0 C0", "power 30", "power 0", "end"}));
}

TEST(TeachControl, BudgetsEndARunBetweenRecords) {
  Panel panel(kProgram);
  EXPECT_EQ(panel.machine.run_to_end({.motions = 2}), Status::budget);
  EXPECT_EQ(panel.machine.position().values[0], -10);
}

}  // namespace
}  // namespace kerf::test
