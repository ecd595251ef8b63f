// Whatever an operator does, no axis breaks a limit, the points are one period apart and the
// machine knows where it is.
#include "random_operator.hpp"

#include <cmath>

#include "bench.hpp"

namespace kerf::test {
namespace {

constexpr int kOperators = 40;
constexpr int kActions = 120;

/// Holds speeds and accelerations of all axes against what the machine file allows.
class LimitCheck : public motion::AxisPointSink {
 public:
  explicit LimitCheck(const machine::MachineDefinition& definition)
      : limits_(definition.joint_limits()),
        axes_(definition.driven.size()),
        period_s_(definition.interpolator.period_s) {}

  void start(const motion::AxisPoint& at) override {
    last_ = at.joints;
    speed_ = {};
    time_s_ = at.tip.time_s;
    seen_ = 0;
  }
  void take(const motion::AxisPoint& point) override {
    const double dt_s = point.tip.time_s - time_s_;
    EXPECT_NEAR(dt_s, period_s_, 1e-9);
    for (std::size_t i = 0; i < axes_; ++i) {
      const double speed = (point.joints.values[i] - last_.values[i]) / dt_s;
      const double acceleration = (speed - speed_.values[i]) / dt_s;
      worst_speed = std::max(worst_speed, std::fabs(speed) / limits_.velocity.values[i]);
      worst_acceleration =
          std::max(worst_acceleration, std::fabs(acceleration) / limits_.acceleration.values[i]);
      speed_.values[i] = speed;
    }
    last_ = point.joints;
    time_s_ = point.tip.time_s;
    ++seen_;
  }

  double worst_speed = 0;
  double worst_acceleration = 0;
  [[nodiscard]] const base::JointPoint& at() const { return last_; }

 private:
  planner::AxisLimits limits_;
  std::size_t axes_;
  double period_s_;
  base::JointPoint last_;
  base::AxisVector speed_;
  double time_s_ = 0;
  int seen_ = 0;
};

TEST(RandomOperator, BreaksNoLimitAndLosesNoPlace) {
  for (int seed = 1; seed <= kOperators; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Bench bench;
    LimitCheck check(bench->definition());
    bench->add_point_sink(check);
    bench.load(kOperatedProgram);
    Operator person(bench, static_cast<unsigned>(seed));
    for (int i = 0; i < kActions; ++i) {
      person.act();
      bench->advance(person.pause_s());
      const machine::Snapshot shown = bench.now();
      ASSERT_EQ(shown.joints, check.at()) << person.trail();
      for (std::size_t axis = 0; axis < 3; ++axis)
        ASSERT_NEAR(shown.machine.values[axis], shown.joints.values[axis], 1e-12) << person.trail();
      if (shown.status == Status::alarm) {
        ASSERT_TRUE(shown.alarm);
        bench->perform(Reset{});
      } else {
        ASSERT_FALSE(shown.alarm);
      }
    }
    // Differences of points that are rounded to doubles; chords of arcs.
    EXPECT_LT(check.worst_speed, 1 + 1e-6) << person.trail();
    EXPECT_LT(check.worst_acceleration, 1.001) << person.trail();
    // In the end it still does what it should.
    bench->perform(Reset{});
    bench->advance(60);
    EXPECT_DONE(bench->perform(SetDials{100, 100, 100}));
    EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, false}));
    EXPECT_DONE(bench->perform(TurnSwitch{Switch::optional_stop, false}));
    EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
    EXPECT_DONE(bench->perform(CycleStart{}));
    EXPECT_EQ(bench.settle(), Status::end) << person.trail();
    EXPECT_EQ(bench.now().machine.values[2], 5);
  }
}

}  // namespace
}  // namespace kerf::test
