// Whatever an operator does with a pattern, no motor leaves its limits, and none loses a pulse.
#include <cmath>
#include <random>

#include "pattern_bench.hpp"

namespace kerf::test {
namespace {

/// No motor is faster than its limit, beyond its travel, or skips a period.
class TravelCheck : public motion::AxisPointSink {
 public:
  explicit TravelCheck(const machine::MachineDefinition& definition) : machine_(definition) {}

  /// A step back leads to where the axes have been.
  void expect_jump() { may_jump_ = true; }
  void expect_no_jump() { may_jump_ = false; }
  void start(const motion::AxisPoint& at) override {
    for (std::size_t i = 0; !may_jump_ && i < machine_.driven.size(); ++i)
      EXPECT_NEAR(at.joints.values[i], last_.values[i], 1e-4) << "axis " << i << " has jumped";
    may_jump_ = false;
    last_ = at.joints;
    time_s_ = at.tip.time_s;
  }
  void take(const motion::AxisPoint& point) override {
    const double dt_s = point.tip.time_s - time_s_;
    EXPECT_NEAR(dt_s, machine_.interpolator.period_s, 1e-9);
    for (std::size_t i = 0; i < machine_.driven.size(); ++i) {
      const machine::DrivenAxis& axis = machine_.driven[i];
      const double at = point.joints.values[i];
      const double speed = std::fabs(at - last_.values[i]) / dt_s * 60;
      ASSERT_LE(speed, axis.velocity_per_min * (1 + 1e-6)) << axis.name;
      ASSERT_GE(at, axis.travel_low - 1e-9) << axis.name;
      ASSERT_LE(at, axis.travel_high + 1e-9) << axis.name;
    }
    last_ = point.joints;
    time_s_ = point.tip.time_s;
  }
  [[nodiscard]] const base::JointPoint& at() const { return last_; }

 private:
  machine::MachineDefinition machine_;
  base::JointPoint last_;
  double time_s_ = 0;
  bool may_jump_ = false;
};

class Operator {
 public:
  Operator(Bench& bench, TravelCheck& check, unsigned seed)
      : bench_(bench), check_(check), random_(seed) {}

  void act() {
    LiveMachine& machine = *bench_;
    const auto keep = [](const base::Outcome<void>& outcome) {
      if (!outcome) {
        EXPECT_FALSE(outcome.error().message.empty());
      }
    };
    switch (number(16)) {
      case 0:
      case 1:
      case 2: keep(machine.perform(CycleStart{})); break;
      case 3:
      case 4: keep(machine.perform(FeedHold{})); break;
      case 5:
        if (number(3) == 0) machine.perform(Reset{});
        break;
      case 6: keep(machine.perform(TurnSwitch{Switch::single_block, number(2) == 0})); break;
      case 7: keep(machine.perform(SetDials{50 + number(100), 100, 100})); break;
      case 8: keep(machine.perform(SetMode{static_cast<Mode>(number(6))})); break;
      case 9: keep(machine.perform(SetMode{Mode::automatic})); break;
      case 10:
        keep(machine.perform(JogBy{number(2) == 0 ? "Z" : "C", number(4) + 1.0, 200}));
        break;
      case 11: keep(machine.perform(TakeStep{machine::Step::over})); break;
      case 12: keep(machine.perform(Home{})); break;
      case 13:
        if (number(4) == 0)
          keep(machine.perform(StartAt{static_cast<std::uint32_t>(number(30) + 1)}));
        break;
      case 14:
        if (number(4) == 0) step_back();
        break;
      default: keep(machine.perform(SetMode{Mode::automatic}));
    }
  }
  double pause_s() { return std::uniform_real_distribution<double>(0, 1.5)(random_); }

 private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  void step_back() {
    check_.expect_jump();
    if (const auto done = bench_->perform(StepBack{}); !done) check_.expect_no_jump();
  }

  Bench& bench_;
  TravelCheck& check_;
  std::mt19937 random_;
};

TEST(RandomOperatorOfAPattern, BreaksNoLimitAndLosesNoPulse) {
  constexpr unsigned kOperators = 40;
  for (unsigned seed = 1; seed <= kOperators; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Bench bench("arm4");
    TravelCheck check(bench->definition());
    bench->add_point_sink(check);
    const std::string listing = random_listing(seed, 30);
    with_pattern(bench, listing);
    Operator person(bench, check, seed);
    for (int i = 0; i < 120; ++i) {
      person.act();
      bench->advance(person.pause_s());
      ASSERT_EQ(bench.now().joints, check.at());
      if (bench.status() == Status::alarm) bench->perform(Reset{});
    }
    // In the end it still makes the whole figure.
    bench->perform(Reset{});
    bench->advance(60);
    EXPECT_DONE(bench->perform(SetDials{100, 100, 100}));
    EXPECT_DONE(bench->perform(TurnSwitch{Switch::single_block, false}));
    EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
    EXPECT_DONE(bench->perform(Home{}));
    bench.settle();
    EXPECT_DONE(bench->perform(SetMode{Mode::automatic}));
    EXPECT_DONE(bench->perform(CycleStart{}));
    ASSERT_EQ(bench.settle(), Status::end);
    Replayed replayed;
    replay(bench->definition(), listing, replayed);
    EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
  }
}

// However often it is held: the counts in the end are the sum of the records.
TEST(RandomOperatorOfAPattern, LosesNoPulseByHolds) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string listing = random_listing(seed + 100, 20);
    Bench bench("arm4");
    TravelCheck check(bench->definition());
    bench->add_point_sink(check);
    with_pattern(bench, listing);
    std::mt19937 random(seed);
    EXPECT_DONE(bench->perform(CycleStart{}));
    while (bench.status() != Status::end) {
      bench->advance(std::uniform_real_distribution<double>(0, 1)(random));
      if (!bench->perform(FeedHold{})) break;
      bench->advance(std::uniform_real_distribution<double>(0, 1.2)(random));
      if (bench.status() == Status::end) break;
      EXPECT_DONE(bench->perform(CycleStart{}));
    }
    ASSERT_EQ(bench.settle(), Status::end);
    Replayed replayed;
    replay(bench->definition(), listing, replayed);
    EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
    EXPECT_GE(bench.now().time_s, replayed.time_s - 1e-9);
  }
}

}  // namespace
}  // namespace kerf::test
