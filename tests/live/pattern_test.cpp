// A pattern on the panel: the same pulses as `kerf pattern replay`, and what an operator can do on
// the way.
#include <cmath>
#include <random>
#include <sstream>

#include "base/source_file.hpp"
#include "bench.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "machine/pattern_replay.hpp"
#include "machine/virtual_machine.hpp"

namespace kerf::test {
namespace {

using machine::PatternMachine;
using machine::PatternReplay;

constexpr const char* kListing = "F Z 200\nF T2 4000\nS 0 12 -7\nS 3 30 30\nF Z -200\n";

/// What `kerf pattern replay` makes of a listing.
struct Replayed {
  Points points;
  double time_s = 0;
  drive::ArmCounts counters;
};

void replay(const machine::MachineDefinition& definition, const std::string& listing,
            Replayed& into) {
  const auto counting = PatternMachine::of(definition);
  ASSERT_TRUE(counting);
  PatternReplay replay(*counting);
  replay.add_sink(into.points);
  const auto file = base::SourceFile::from_text("w.txt", listing);
  drive::ListingReader reader(*file, base::FileId{0});
  for (;;) {
    const auto move = reader.next();
    ASSERT_TRUE(move);
    if (!*move) break;
    drive::each_record(**move, [&](const drive::PatternRecord& record) {
      EXPECT_TRUE(replay.take(record));
    });
  }
  replay.finish();
  into.time_s = replay.time_s();
  into.counters = replay.counters();
}

/// Records of all kinds that stay within the travel of the arm.
std::string random_listing(unsigned seed, int records) {
  std::mt19937 random(seed);
  const auto number = [&](int most) {
    return std::uniform_int_distribution<int>(-most, most)(random);
  };
  std::ostringstream text;
  for (int i = 0; i < records; ++i) {
    switch (number(3)) {
      case -3: text << "F T1 " << number(700) << '\n'; break;
      case -2: text << "F T2 " << number(700) << '\n'; break;
      case -1: text << "F T3 " << number(90) << '\n'; break;
      case 3: text << "F Z " << number(90) << '\n'; break;
      default: text << "S " << number(30) << ' ' << number(30) << ' ' << number(30) << '\n';
    }
  }
  return text.str();
}

Bench& with_pattern(Bench& bench, const std::string& listing) {
  return bench.load(listing, "w.pat", "pattern");
}

void expect_same_points(const Points& a, const Points& b) {
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t i = 0; i < a.all.size(); ++i) {
    ASSERT_EQ(a.all[i].tip.time_s, b.all[i].tip.time_s) << i;
    ASSERT_EQ(a.all[i].joints, b.all[i].joints) << i;
    ASSERT_EQ(a.all[i].tip.tip, b.all[i].tip.tip) << i;
    ASSERT_EQ(a.all[i].tip.mark.line, b.all[i].tip.mark.line) << i;
  }
}

TEST(PatternOnThePanel, MakesThePointsOfAReplay) {
  for (const char* const name : {"arm4", "cartesian-step"}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      const std::string listing = random_listing(seed, 40);
      Bench bench(name);
      Points live;
      bench->add_point_sink(live);
      with_pattern(bench, listing);
      EXPECT_DONE(bench->cycle_start());
      ASSERT_EQ(bench.settle(0.001 * seed * seed), Status::end);
      Replayed replayed;
      replay(bench->definition(), listing, replayed);
      expect_same_points(live, replayed.points);
      EXPECT_NEAR(bench.now().time_s, replayed.time_s, 0.001 + 1e-9);
    }
  }
}

TEST(PatternOnThePanel, RunsWithoutPanelAsAReplayDoes) {
  const auto definition = *machine::find_machine("arm4");
  const std::string listing = random_listing(7, 60);
  machine::VirtualMachine batch(definition, control::Memory(definition.parameters.n_offsets),
                                {.pages = {}, .dialect = "pattern"});
  Points points;
  batch.add_point_sink(points);
  batch.load(base::SourceFile::from_text("w.pat", listing));
  EXPECT_EQ(batch.run_to_end(), machine::VirtualMachine::Status::end);
  Replayed replayed;
  replay(definition, listing, replayed);
  expect_same_points(points, replayed.points);
}

TEST(PatternOnThePanel, ShowsTheRecordThatItIsIn) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->cycle_start());
  bench->advance(0.3);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_EQ(bench.now().text, "F Z 200");
  bench->advance(1);
  EXPECT_EQ(bench.now().text, "F T2 4000");
  EXPECT_EQ(bench.status(), Status::running);
}

TEST(PatternOnThePanel, StopsBehindEachRecordInSingleBlock) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->set_switch(Switch::single_block, true));
  std::vector<std::string> passed;
  for (int i = 0; i < 5; ++i) {
    EXPECT_DONE(bench->cycle_start());
    ASSERT_EQ(bench.settle(), Status::stopped);
    passed.push_back(bench.now().text);
  }
  EXPECT_EQ(passed, (std::vector<std::string>{"F Z 200", "F T2 4000", "S 0 12 -7", "S 3 30 30",
                                              "F Z -200"}));
  EXPECT_DONE(bench->cycle_start());
  EXPECT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
}

TEST(PatternOnThePanel, SingleBlockSwitchedOnTheWayStopsBehindTheRecord) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\nS 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->cycle_start());
  bench->advance(0.4);
  EXPECT_EQ(bench.line(), 2U);
  EXPECT_DONE(bench->set_switch(Switch::single_block, true));
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 60 * 0.005);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 90 * 0.005);
}

TEST(PatternOnThePanel, StepsAndRunsToALine) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->step(machine::Step::over));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_DONE(bench->step(machine::Step::over));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 2U);
  EXPECT_DONE(bench->run_to("", 4));
  ASSERT_EQ(bench.settle(), Status::step);
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], (4000 - 7) * 0.005);
  EXPECT_DONE(bench->step_back());
  EXPECT_EQ(bench.line(), 3U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], 4000 * 0.005);
  EXPECT_DONE(bench->cycle_start());
  EXPECT_EQ(bench.settle(), Status::end);
}

// 4000 pulses take 10 s; the ramp from 400 pulses/s needs 0.29 s.
TEST(PatternOnThePanel, AHoldCutsAFastRecordShortAndTheRestFollows) {
  Bench bench("arm4");
  with_pattern(bench, "F T2 4000\nS 0 1 1\n");
  EXPECT_DONE(bench->cycle_start());
  bench->advance(3);
  EXPECT_DONE(bench->feed_hold());
  bench->advance(0.35);
  ASSERT_EQ(bench.status(), Status::held);
  const double pulses = bench.now().joints.values[1] * 200;
  EXPECT_NEAR(pulses, std::round(pulses), 1e-6) << "a motor rests on a whole pulse";
  EXPECT_GT(pulses, 1000);
  EXPECT_LT(pulses, 1400);
  bench->advance(5);
  EXPECT_EQ(bench.now().joints.values[1] * 200, pulses);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], 4001 * 0.005);
}

TEST(PatternOnThePanel, AHoldComesAtTheEndOfACut) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->cycle_start());
  bench->advance(0.1);
  EXPECT_DONE(bench->feed_hold());
  bench->advance(0.3);
  ASSERT_EQ(bench.status(), Status::held);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 30 * 0.005);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 60 * 0.005);
}

TEST(PatternOnThePanel, BeginsWhereEveryMotorStandsAtItsZero) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->cycle_start());
  bench->advance(6);
  bench->reset();
  bench->advance(2);
  ASSERT_EQ(bench.status(), Status::idle);
  EXPECT_REFUSED(bench->cycle_start(), "bring the axes to their reference points");
  EXPECT_DONE(bench->set_mode(Mode::reference));
  EXPECT_DONE(bench->home());
  ASSERT_NE(bench.settle(), Status::alarm);
  for (std::size_t joint = 0; joint < 4; ++joint)
    EXPECT_NEAR(bench.now().joints.values[joint], 0, 1e-5) << joint;
  EXPECT_DONE(bench->set_mode(Mode::automatic));
  Points again;
  bench->add_point_sink(again);
  EXPECT_DONE(bench->cycle_start());
  EXPECT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  EXPECT_EQ(again.all.back().joints, replayed.points.all.back().joints);
}

TEST(PatternOnThePanel, AxesAreMovedByHandBehindItAndNotWithinIt) {
  Bench bench("arm4");
  with_pattern(bench, "F T2 -2000\nF T1 4000\nF Z 300\n");
  EXPECT_DONE(bench->set_switch(Switch::single_block, true));
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->set_mode(Mode::jog));
  EXPECT_REFUSED(bench->jog_by("Z", 1), "counts its pulses on from here");
  EXPECT_DONE(bench->set_mode(Mode::automatic));
  EXPECT_DONE(bench->set_switch(Switch::single_block, false));
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_DONE(bench->set_mode(Mode::jog));
  EXPECT_DONE(bench->jog_by("Z", 1.5));
  bench.settle();
  const machine::Snapshot shown = bench.now();
  EXPECT_NEAR(shown.joints.values[3], 4.5, 1e-9);
  EXPECT_NEAR(shown.joints.values[0], 20, 1e-9);
  EXPECT_NEAR(shown.joints.values[1], -10, 1e-9);
}

TEST(PatternOnThePanel, ARecordBeyondTheTravelIsAnAlarmBeforeItMoves) {
  Bench bench("arm4");
  with_pattern(bench, "F Z 200\nF Z 9801\nF Z -200\n");
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::alarm);
  const auto alarm = bench.now().alarm;
  ASSERT_TRUE(alarm);
  EXPECT_EQ(alarm->code, "LIMIT");
  EXPECT_EQ(alarm->line, 2U);
  EXPECT_NE(alarm->message.find("Z goes to 100.01"), std::string::npos) << alarm->message;
  EXPECT_DOUBLE_EQ(bench.now().joints.values[3], 2);
}

TEST(PatternOnThePanel, AWrongLineIsAnAlarmWithItsPlace) {
  Bench bench("arm4");
  with_pattern(bench, "F Z 200\nF Q 3\n");
  const auto found = bench->check();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].place.line, 2U);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::alarm);
  EXPECT_EQ(bench.now().alarm->code, "PATTERN_TEXT");
  EXPECT_EQ(bench.now().alarm->line, 2U);
  EXPECT_EQ(bench.now().alarm->column, 3U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[3], 2) << "what was before it is made";
}

TEST(PatternOnThePanel, ALineOfManyRecordsIsOneBlock) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 9000 -3000\nF Z 1\n");
  EXPECT_DONE(bench->set_switch(Switch::single_block, true));
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::stopped);
  EXPECT_EQ(bench.line(), 1U);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 45);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[1], -15);
  Bench endless("arm4");
  with_pattern(endless, "S 0 2147483647 0\n");
  EXPECT_DONE(endless->cycle_start());
  ASSERT_EQ(endless.settle(), Status::alarm);
  EXPECT_EQ(endless.now().alarm->code, "PATTERN_TEXT");
}

TEST(PatternOnThePanel, IsNotForMachinesThatCountNoPulses) {
  for (const char* const name : {"mill3", "laser3", "laser5"}) {
    Bench bench(name);
    EXPECT_REFUSED(bench->load(machine::ProgramText::of("w.pat", kListing), "pattern"),
                   "has no controller for patterns");
    EXPECT_FALSE(bench->program());
  }
}

TEST(PatternOnThePanel, RecordsAreNoEntries) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->set_mode(Mode::mdi));
  EXPECT_REFUSED(bench->mdi("F Z 200"), "its records are no blocks to be entered");
}

TEST(PatternOnThePanel, TellsThatDialsDoNotChangeItsTimes) {
  Bench bench("arm4");
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->set_dials({50, 100, 100}));
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.now().messages.size(), 1U);
  EXPECT_NE(bench.now().messages[0].find("have their own times"), std::string::npos);
  EXPECT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), kListing, replayed);
  expect_same_points(points, replayed.points);
}

TEST(PatternOnThePanel, ADialAtZeroHolds) {
  Bench bench("arm4");
  with_pattern(bench, "S 0 30 0\nS 0 30 0\n");
  EXPECT_DONE(bench->cycle_start());
  bench->advance(0.1);
  EXPECT_DONE(bench->set_dials({0, 100, 100}));
  bench->advance(20);
  EXPECT_DOUBLE_EQ(bench.now().joints.values[0], 30 * 0.005);
  EXPECT_DONE(bench->set_dials({100, 100, 100}));
  EXPECT_EQ(bench.settle(), Status::end);
}

// The motors are brought to where the record begins, the lift clear of the work first.
TEST(PatternOnThePanel, StartsAtALine) {
  constexpr const char* listing = "F T2 400\nF T1 300\nS 5 30 -30\nS 0 30 30\nF Z 10\n";
  Bench bench("arm4");
  with_pattern(bench, listing);
  EXPECT_DONE(bench->start_at(4));
  EXPECT_EQ(bench.line(), 4U);
  EXPECT_EQ(bench.now().joints, base::AxisVector{}) << "nothing moves before cycle start";
  Points points;
  bench->add_point_sink(points);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  Replayed replayed;
  replay(bench->definition(), listing, replayed);
  EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
  double highest = 0;
  for (const machine::AxisPoint& point : points.all) {
    const bool arms_move = point.joints.values[0] != 0 && point.joints.values[0] < 1.6;
    if (arms_move) {
      EXPECT_DOUBLE_EQ(point.joints.values[3], 2);
    }
    highest = std::max(highest, point.joints.values[3]);
  }
  EXPECT_DOUBLE_EQ(highest, 2);
}

TEST(PatternOnThePanel, IsSeenAtAnyTimeOfItsRun) {
  Bench bench("arm4");
  const std::string listing = random_listing(3, 12);
  with_pattern(bench, listing);
  Replayed replayed;
  replay(bench->definition(), listing, replayed);
  const std::size_t middle = replayed.points.all.size() / 2;
  const machine::AxisPoint& expected = replayed.points.all[middle];
  const auto ahead = bench->state_at(expected.tip.time_s);
  ASSERT_TRUE(ahead);
  EXPECT_EQ((*ahead)->joints, expected.joints);
  EXPECT_EQ((*ahead)->line, expected.tip.mark.line);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  const auto back = bench->state_at(expected.tip.time_s);
  ASSERT_TRUE(back);
  EXPECT_EQ((*back)->joints, expected.joints);
}

TEST(PatternOnThePanel, ALockedMachineCountsAndStands) {
  Bench bench("arm4");
  EXPECT_DONE(bench->set_switch(Switch::machine_lock, true));
  with_pattern(bench, kListing);
  EXPECT_DONE(bench->cycle_start());
  ASSERT_EQ(bench.settle(), Status::end);
  EXPECT_EQ(bench.now().joints, base::AxisVector{});
}

/// No motor is faster than its limit, beyond its travel, or skips a period.
class TravelCheck : public machine::AxisPointSink {
 public:
  explicit TravelCheck(const machine::MachineDefinition& definition) : machine_(definition) {}

  /// A step back leads to where the axes have been.
  void expect_jump() { may_jump_ = true; }
  void expect_no_jump() { may_jump_ = false; }
  void start(const machine::AxisPoint& at) override {
    for (std::size_t i = 0; !may_jump_ && i < machine_.driven.size(); ++i)
      EXPECT_NEAR(at.joints.values[i], last_.values[i], 1e-4) << "axis " << i << " has jumped";
    may_jump_ = false;
    last_ = at.joints;
    time_s_ = at.tip.time_s;
  }
  void take(const machine::AxisPoint& point) override {
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
  [[nodiscard]] const base::AxisVector& at() const { return last_; }

 private:
  machine::MachineDefinition machine_;
  base::AxisVector last_;
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
      case 2: keep(machine.cycle_start()); break;
      case 3:
      case 4: keep(machine.feed_hold()); break;
      case 5:
        if (number(3) == 0) machine.reset();
        break;
      case 6: keep(machine.set_switch(Switch::single_block, number(2) == 0)); break;
      case 7: keep(machine.set_dials({50 + number(100), 100, 100})); break;
      case 8: keep(machine.set_mode(static_cast<Mode>(number(6)))); break;
      case 9: keep(machine.set_mode(Mode::automatic)); break;
      case 10: keep(machine.jog_by(number(2) == 0 ? "Z" : "C", number(4) + 1, 200)); break;
      case 11: keep(machine.step(machine::Step::over)); break;
      case 12: keep(machine.home()); break;
      case 13:
        if (number(4) == 0) keep(machine.start_at(static_cast<std::uint32_t>(number(30) + 1)));
        break;
      case 14:
        if (number(4) == 0) step_back();
        break;
      default: keep(machine.set_mode(Mode::automatic));
    }
  }
  double pause_s() { return std::uniform_real_distribution<double>(0, 1.5)(random_); }

 private:
  int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  void step_back() {
    check_.expect_jump();
    if (const auto done = bench_->step_back(); !done) check_.expect_no_jump();
  }

  Bench& bench_;
  TravelCheck& check_;
  std::mt19937 random_;
};

TEST(PatternOnThePanel, BreaksNoLimitAndLosesNoPulseWhateverAnOperatorDoes) {
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
      if (bench.status() == Status::alarm) bench->reset();
    }
    // In the end it still makes the whole figure.
    bench->reset();
    bench->advance(60);
    EXPECT_DONE(bench->set_dials({100, 100, 100}));
    EXPECT_DONE(bench->set_switch(Switch::single_block, false));
    EXPECT_DONE(bench->set_mode(Mode::reference));
    EXPECT_DONE(bench->home());
    bench.settle();
    EXPECT_DONE(bench->set_mode(Mode::automatic));
    EXPECT_DONE(bench->cycle_start());
    ASSERT_EQ(bench.settle(), Status::end);
    Replayed replayed;
    replay(bench->definition(), listing, replayed);
    EXPECT_EQ(bench.now().joints, replayed.points.all.back().joints);
  }
}

// However often it is held: the counts in the end are the sum of the records.
TEST(PatternOnThePanel, HoldsLoseNoPulse) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string listing = random_listing(seed + 100, 20);
    Bench bench("arm4");
    TravelCheck check(bench->definition());
    bench->add_point_sink(check);
    with_pattern(bench, listing);
    std::mt19937 random(seed);
    EXPECT_DONE(bench->cycle_start());
    while (bench.status() != Status::end) {
      bench->advance(std::uniform_real_distribution<double>(0, 1)(random));
      if (!bench->feed_hold()) break;
      bench->advance(std::uniform_real_distribution<double>(0, 1.2)(random));
      if (bench.status() == Status::end) break;
      EXPECT_DONE(bench->cycle_start());
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
