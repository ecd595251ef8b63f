// Whoever takes set-points: where they begin, and how a drive that cannot follow ends the run.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "machine/run/batch_run.hpp"

namespace kerf::test {
namespace {

using machine::BatchRun;
using motion::AxisPoint;
using Status = machine::RunStatus;

/// Keeps what comes; may answer it.
class Watcher : public motion::AxisPointSink {
 public:
  void start(const AxisPoint& at) override {
    starts.push_back(at);
    points_before_start.push_back(points);
  }
  void take(const AxisPoint& point) override {
    last = point;
    ++points;
    if (answer) answer(point);
  }

  std::function<void(const AxisPoint&)> answer;
  std::vector<AxisPoint> starts;
  std::vector<std::size_t> points_before_start;
  std::optional<AxisPoint> last;
  std::size_t points = 0;
};

class Drives : public ::testing::Test {
 protected:
  BatchRun& load(const std::string& blocks, const std::string& name = "mill3") {
    const machine::MachineDefinition definition = *machine::find_machine(name);
    machine_.emplace(definition, control::Memory(definition.parameters.n_offsets));
    machine_->add_point_sink(watcher_);
    machine_->load(base::SourceFile::from_text("part.nc", "O1\nG21G90G94\n" + blocks + "M30\n"));
    return *machine_;
  }
  // An alarm at the first point whose X is this far.
  void raise_behind(double x) {
    watcher_.answer = [this, x](const AxisPoint& point) {
      if (point.tip.tip.values[0] < x) return;
      base::Diagnostic alarm = base::make_error(base::Code::step_rate, {}, "too fast");
      alarm.place.line = point.tip.mark.block.line;
      machine_->raise(alarm);
    };
  }

  Watcher watcher_;
  std::optional<BatchRun> machine_;
};

TEST_F(Drives, TheStartComesBeforeThePointsAndIsWhereTheJointsStand) {
  BatchRun& machine = load("G00X1.\n", "laser5");
  EXPECT_EQ(machine.run_to_end(), Status::end);
  ASSERT_EQ(watcher_.starts.size(), 1U);
  EXPECT_EQ(watcher_.points_before_start[0], 0U);
  EXPECT_EQ(watcher_.starts[0].tip.time_s, 0);
  EXPECT_EQ(watcher_.starts[0].tip.tip, base::AxisVector{});
  const base::AxisVector carriage{{-80, 0, 150}};  // r_c and r_a beside the focus
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(watcher_.starts[0].joints.values[i], carriage.values[i], 1e-9) << i;
  }
  EXPECT_EQ(watcher_.last->tip.tip.values[0], 1);
}

TEST_F(Drives, AnAlarmOfADriveEndsTheRunWhereTheAxesAre) {
  BatchRun& machine = load("G01X10.F600\nX20.\nX30.\n");
  raise_behind(12);
  EXPECT_EQ(machine.run_to_end(), Status::alarm);
  ASSERT_TRUE(machine.alarm());
  EXPECT_EQ(machine.alarm()->number, "STEP_RATE");
  EXPECT_EQ(machine.alarm()->place.line, 4U);
  EXPECT_EQ(machine.position(), base::machine_of(watcher_.last->tip.tip, {}));
  EXPECT_EQ(machine.time_s(), watcher_.last->tip.time_s);
  EXPECT_NEAR(machine.position().values[0], 12, 0.01);
}

TEST_F(Drives, AnAlarmOfADriveEndsAnEndlessProgram) {
  BatchRun& machine = load("G91G01F600\nN1X1.\nX-1.\nX2.\nGOTO1\n");
  raise_behind(500);
  EXPECT_EQ(machine.run_to_end({.seconds = 0, .motions = 0}), Status::alarm);
  EXPECT_LT(machine.statistics().motions(), 5000U);
}

TEST_F(Drives, AnAlarmOfADriveComesBeforeThatOfABlockBehindIt) {
  BatchRun& machine = load("G01X10.F600\n#1=1/0\n");
  raise_behind(5);
  EXPECT_EQ(machine.run_to_end(), Status::alarm);
  EXPECT_EQ(machine.alarm()->number, "STEP_RATE");
}

TEST_F(Drives, ResetGoesOnFromTheEndOfWhatWasCommanded) {
  BatchRun& machine = load("G91G01X10.F600\n");
  raise_behind(5);
  EXPECT_EQ(machine.run_to_end(), Status::alarm);
  watcher_.answer = nullptr;
  machine.reset();
  EXPECT_EQ(machine.run_to_end(), Status::end);
  ASSERT_EQ(watcher_.starts.size(), 2U);
  EXPECT_EQ(watcher_.starts[1].tip.tip.values[0], 10);
  EXPECT_GT(watcher_.starts[1].tip.time_s, 0);
  EXPECT_EQ(watcher_.last->tip.tip.values[0], 20);
}

TEST_F(Drives, TheBudgetOfTimeEndsALongMotionToo) {
  BatchRun& machine = load("G00X1.\nG04X90000.\n");
  EXPECT_EQ(machine.run_to_end({.seconds = 0.05}), Status::budget);
  ASSERT_TRUE(machine.notice());
  EXPECT_EQ(machine.notice()->number, "BUDGET");
  EXPECT_LT(machine.time_s(), 90000);
}

}  // namespace
}  // namespace kerf::test
