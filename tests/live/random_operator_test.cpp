// Whatever an operator does, no axis breaks a limit, the points are one period apart and the
// machine knows where it is.
#include <cmath>
#include <random>

#include "bench.hpp"

namespace kerf::test {
namespace {

using machine::Step;

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

class Operator {
 public:
  Operator(Bench& bench, unsigned seed) : bench_(bench), random_(seed) {}

  void act() {
    LiveMachine& machine = *bench_;
    switch (number(21)) {
      case 0: keep(machine.cycle_start()); break;
      case 1: keep(machine.cycle_start()); break;
      case 2: keep(machine.feed_hold()); break;
      case 3:
        if (number(3) == 0) machine.reset();
        break;
      case 4: keep(machine.set_switch(Switch::single_block, number(2) == 0)); break;
      case 5: keep(machine.set_switch(Switch::dry_run, number(2) == 0)); break;
      case 6: keep(machine.set_dials({number(201), number(101), 50 + number(71)})); break;
      case 7: keep(machine.set_dials({100, 100, 100})); break;
      case 8: keep(machine.set_mode(static_cast<Mode>(number(6)))); break;
      case 9: keep(machine.set_mode(Mode::automatic)); break;
      case 10: keep(machine.jog(number(2) == 0 ? "X" : "Z", number(2) == 0 ? 3000 : -3000)); break;
      case 11: keep(machine.jog_by("Y", number(40) - 20, 2000)); break;
      case 12: keep(machine.jog_stop()); break;
      case 13: keep(machine.step(static_cast<Step>(number(3)))); break;
      case 14: keep(machine.mdi("G91G01X1.F1000\nG90")); break;
      case 15: keep(machine.home()); break;
      case 16: keep(machine.set_block_skip(number(2) == 0 ? 1U << 1U : 0)); break;
      case 17: keep(machine.set_switch(Switch::optional_stop, number(2) == 0)); break;
      case 18: keep(machine.interrupt()); break;
      case 19: keep(machine.set_variable("#101", number(9))); break;
      default:
        if (number(4) == 0) keep(machine.step_back());
    }
    trail_ += machine::name_of(bench_.status());
    trail_ += ' ';
  }
  double pause_s() { return std::uniform_real_distribution<double>(0, 0.4)(random_); }
  [[nodiscard]] const std::string& trail() const { return trail_; }

 private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  void keep(const base::Outcome<void>& outcome) {
    if (!outcome) {
      EXPECT_FALSE(outcome.error().message.empty());
    }
  }

  Bench& bench_;
  std::mt19937 random_;
  std::string trail_;
};

constexpr const char* kProgram =
    "O1\n#100=0\nN1 G90G94G00X5.Y0Z2.\nG01Z-1.F1500\nG91G64\nWHILE[#100LT20]DO1\nX1.Y0.5\n"
    "/X0.3Y1.\nX-0.2Y0.7\n/X[#101/10]\n#100=#100+1\nEND1\nM96P3\nG02X10.I5.\nM01\nG65P2A3.\nM97\n"
    "G04X0.3\nG90G00Z5.\nM30\nO3\nG91G01X0.4\nX-0.4\nM99\n"
    "O2\nG91G01X#1\nY[-#1*5]\nG03X-2.Y2.R2.\nM99\n";

TEST(RandomOperator, BreaksNoLimitAndLosesNoPlace) {
  for (int seed = 1; seed <= kOperators; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Bench bench;
    LimitCheck check(bench->definition());
    bench->add_point_sink(check);
    bench.load(kProgram);
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
        bench->reset();
      } else {
        ASSERT_FALSE(shown.alarm);
      }
    }
    // Differences of points that are rounded to doubles; chords of arcs.
    EXPECT_LT(check.worst_speed, 1 + 1e-6) << person.trail();
    EXPECT_LT(check.worst_acceleration, 1.001) << person.trail();
    // In the end it still does what it should.
    bench->reset();
    bench->advance(60);
    EXPECT_DONE(bench->set_dials({100, 100, 100}));
    EXPECT_DONE(bench->set_switch(Switch::single_block, false));
    EXPECT_DONE(bench->set_switch(Switch::optional_stop, false));
    EXPECT_DONE(bench->set_mode(Mode::automatic));
    EXPECT_DONE(bench->cycle_start());
    EXPECT_EQ(bench.settle(), Status::end) << person.trail();
    EXPECT_EQ(bench.now().machine.values[2], 5);
  }
}

}  // namespace
}  // namespace kerf::test
