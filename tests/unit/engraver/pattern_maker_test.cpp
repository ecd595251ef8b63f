// Programs as patterns, and patterns on the machine: what the wheel does against what was
// programmed, measured by replays that share nothing with the maker but the linkage.
#include "engraver/pattern_maker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "drive/pattern/reader.hpp"
#include "drive_recorder.hpp"
#include "engraver/pattern_replay.hpp"
#include "geometry/angle.hpp"
#include "machine/run/batch_run.hpp"
#include "seeded_random.hpp"
#include "set_machine.hpp"

namespace kerf::engraver {
namespace {

using base::AxisVector;
using base::JointPoint;
using base::TipPoint;
using drive::ArmAxis;
using drive::ArmCounts;
using drive::FastRecord;
using drive::PatternRecord;
using drive::Triplet;
using machine::PatternMachine;
using test::machine_with;

struct Made {
  std::vector<PatternRecord> records;
  PatternReport report;
  std::optional<base::Diagnostic> alarm;
};

// Through a file, as users have it.
std::vector<PatternRecord> records_in(const std::string& path) {
  const auto file = base::SourceFile::open(path);
  drive::PatternReader reader(**file, base::FileId{0}, {});
  std::vector<PatternRecord> records;
  for (;;) {
    auto record = reader.next();
    EXPECT_TRUE(record);
    if (!record || !*record) return records;
    records.push_back(**record);
  }
}

Made made_of(const std::string& program, const machine::MachineDefinition& definition) {
  const std::string path = testing::TempDir() + "kerf_pattern_maker_test.pat";
  machine::BatchRun machine(definition, control::Memory(definition.parameters.n_offsets));
  machine.load(base::SourceFile::from_text("test.nc", "O1\nG21G90G17\n" + program + "M30\n"));
  const auto motors = PatternMachine::of(machine.definition());
  auto file = base::OutputFile::create(path);
  drive::PatternWriter writer(drive::ByteOrder::big, **file);
  PatternMaker maker(machine, *motors, writer);
  const auto status = machine.run_to_end();
  maker.finish();
  EXPECT_TRUE((*file)->commit());
  Made made{records_in(path), maker.report(), machine.alarm()};
  EXPECT_EQ(status == machine::RunStatus::alarm, made.alarm.has_value());
  std::remove(path.c_str());
  return made;
}

Made made_of(const std::string& program, const std::string& machine = "arm4") {
  return made_of(program, machine_with(machine));
}

// Fast records with their motor from 0; triplets in a row are one S.
std::string listed(const std::vector<PatternRecord>& records) {
  std::string text;
  for (const PatternRecord& record : records) {
    if (const auto* const fast = std::get_if<FastRecord>(&record)) {
      text += "F" + std::to_string(static_cast<int>(fast->axis)) + ":" +
              std::to_string(fast->move().count) + " ";
    } else if (!text.ends_with("S ")) {
      text += "S ";
    }
  }
  return text;
}

ArmCounts sum_of(const std::vector<PatternRecord>& records) {
  ArmCounts sum;
  for (const PatternRecord& record : records) {
    if (const auto* const fast = std::get_if<FastRecord>(&record)) {
      sum[fast->axis] += fast->move().count;
    } else {
      const drive::SlowMove move = std::get<Triplet>(record).move();
      sum[ArmAxis::theta1] += move.theta1;
      sum[ArmAxis::theta2] += move.theta2;
      sum[ArmAxis::theta3] += move.theta3;
    }
  }
  return sum;
}

/// Follows the pulses of a replay and asks for the distance of the tip from the path while the
/// wheel is down.
class Probe : public drive::PulseSink {
 public:
  template <typename Distance>
  Probe(const PatternMachine& machine, Distance distance)
      : machine_(machine), distance_(distance) {}

  void take(const drive::Pulse& pulse) override {
    if (pulse.time_ns != time_ns_) look();
    time_ns_ = pulse.time_ns;
    counts_.values[index(pulse.axis)] += sign(pulse.direction);
  }
  void look() {
    const TipPoint tip = machine_.tip_at(counts_);
    if (tip[machine_.z()] < 0) worst = std::max(worst, distance_(tip));
  }
  double worst = 0;

 private:
  const PatternMachine& machine_;
  std::function<double(const TipPoint&)> distance_;
  ArmCounts counts_;
  std::int64_t time_ns_ = -1;
};

template <typename Distance>
double measured(const Made& made, const machine::MachineDefinition& definition, Distance distance) {
  const auto motors = PatternMachine::of(definition);
  Probe probe(*motors, distance);
  PatternReplay replay(*motors);
  replay.add_sink(probe);
  for (const PatternRecord& record : made.records) EXPECT_TRUE(replay.take(record));
  probe.look();
  EXPECT_EQ(replay.counters(), made.report.counters);
  EXPECT_NEAR(replay.time_s(), made.report.time_s, 1e-9);
  EXPECT_EQ(sum_of(made.records), made.report.counters);
  return probe.worst;
}

double from_circle(const TipPoint& tip, double x, double y, double r) {
  return std::fabs(std::hypot(tip.values[0] - x, tip.values[1] - y) - r);
}

double from_line(const TipPoint& tip, double x0, double y0, double x1, double y1) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  return std::fabs((tip.values[0] - x0) * (y1 - y0) - (tip.values[1] - y0) * (x1 - x0)) / length;
}

constexpr const char* kCircle = "G00Z5.\nX175.Y60.\nG01Z-.1F60.\nG03I-25.F78.\n";
constexpr const char* kLine = "G00Z5.\nX120.Y-80.\nG01Z-.1F60.\nX200.Y40.F78.\n";

TEST(PatternMaker, ACircleStartsAndEndsAtTheCountsOfTheReference) {
  const auto definition = machine_with("arm4");
  const Made made = made_of(kCircle, definition);
  EXPECT_EQ(made.report.counters[ArmAxis::theta1], 18205);
  EXPECT_EQ(made.report.counters[ArmAxis::theta2], -5318);
  const double off =
      measured(made, definition, [](const TipPoint& tip) { return from_circle(tip, 150, 60, 25); });
  EXPECT_NEAR(off, made.report.measured.mm, 1e-6);
  EXPECT_LE(off, made.report.bound.mm);
  // 2 * 4.363323e-5 (186.6 + 132) and a little for joints and chords.
  EXPECT_NEAR(made.report.bound.mm, 0.0278, 0.001);
}

TEST(PatternMaker, AtASpeedOfItsOwnThePatternTakesAsLongAsItsReplay) {
  const auto definition = machine_with("arm4", {{"pattern.cut_speed", "78"}});
  const Made made = made_of(kCircle, definition);
  EXPECT_LE(
      measured(made, definition, [](const TipPoint& tip) { return from_circle(tip, 150, 60, 25); }),
      made.report.bound.mm);
  EXPECT_GT(made.report.time_s, made_of(kCircle).report.time_s);
}

TEST(PatternMaker, MotorsMayTurnTheOtherWay) {
  for (const char* const key : {"axis.Z.steps_per_unit", "axis.T1.steps_per_unit"}) {
    const std::string value = key[5] == 'Z' ? "-100" : "-200";
    const auto definition = machine_with("arm4", {{key, value}});
    const Made made = made_of(kCircle, definition);
    const double off = measured(made, definition,
                                [](const TipPoint& tip) { return from_circle(tip, 150, 60, 25); });
    EXPECT_GT(off, 0.005) << key;
    EXPECT_LE(off, made.report.bound.mm) << key;
  }
}

TEST(PatternMaker, ALineStartsAndEndsAtTheCountsOfTheReference) {
  const auto definition = machine_with("arm4");
  const Made made = made_of(kLine, definition);
  EXPECT_EQ(made.report.counters[ArmAxis::theta1], 15766);
  EXPECT_EQ(made.report.counters[ArmAxis::theta2], -5621);
  const double off = measured(
      made, definition, [](const TipPoint& tip) { return from_line(tip, 120, -80, 200, 40); });
  EXPECT_NEAR(off, made.report.measured.mm, 1e-6);
  EXPECT_LE(off, made.report.bound.mm);
}

// The reference figures of closed loops hold for the ends of samples and the way of the arms in
// proportion between them; single pulses leave that by as much again.
TEST(PatternReference, ClosedLoopErrorsOfEqualSamples) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  struct Loop {
    int samples;
    kinematics::Branch branch;
    std::function<TipPoint(double)> path;
    std::function<double(const TipPoint&)> distance;
    std::array<std::int64_t, 4> counts;  // θ1, θ2 of start and end
    double most_mm;
  };
  const auto circle = [](double u) {
    const double a = 2 * 3.14159265358979323846 * u;
    return TipPoint{{150 + 25 * std::cos(a), 60 + 25 * std::sin(a)}};
  };
  const auto line = [](double u) { return TipPoint{{120 + 80 * u, -80 + 120 * u}}; };
  const auto off_line = [](const TipPoint& tip) { return from_line(tip, 120, -80, 200, 40); };
  const Loop loops[] = {
      {500,
       kinematics::Branch::plus,
       circle,
       [](const TipPoint& tip) { return from_circle(tip, 150, 60, 25); },
       {18205, -5318, 18205, -5318},
       0.0128},
      {450, kinematics::Branch::plus, line, off_line, {22755, -18115, 15766, -5621}, 0.0107},
      {450, kinematics::Branch::minus, line, off_line, {-22755, 4639, -15766, 10145}, 0.0096},
  };
  for (const Loop& loop : loops) {
    JointPoint joints = *motors.kinematics().inverse(loop.path(0), {}, loop.branch);
    ArmCounts at = motors.counts_at(joints);
    EXPECT_EQ(at[ArmAxis::theta1], loop.counts[0]);
    EXPECT_EQ(at[ArmAxis::theta2], loop.counts[1]);
    double worst = loop.distance(motors.tip_at(at));
    for (int i = 1; i <= loop.samples; ++i) {
      joints =
          *motors.kinematics().inverse(loop.path(static_cast<double>(i) / loop.samples), joints);
      const ArmCounts next = motors.counts_at(joints);
      for (double part = 0.05; part < 1.01; part += 0.05) {
        std::array<double, drive::kArmAxes> between{};
        for (std::size_t m = 0; m < between.size(); ++m) {
          const auto from = static_cast<double>(at.values[m]);
          between[m] = from + part * (static_cast<double>(next.values[m]) - from);
        }
        worst =
            std::max(worst, loop.distance(motors.kinematics().forward(motors.joints_at(between))));
      }
      at = next;
    }
    EXPECT_EQ(at[ArmAxis::theta1], loop.counts[2]);
    EXPECT_EQ(at[ArmAxis::theta2], loop.counts[3]);
    EXPECT_LE(worst, loop.most_mm);
    EXPECT_GT(worst, loop.most_mm / 2);
  }
}

TEST(PatternMaker, OrderOfATravelMove) {
  const Made made = made_of("G00Z5.\nX100.Y50.\nZ1.\nX110.\nZ3.\n");
  // Up to 5, upper arm, forearm; 1 is where the next travel begins: up to the 2 of travel_z.
  const std::string text = listed(made.records);
  EXPECT_EQ(text.substr(0, 6), "F3:500");
  EXPECT_NE(text.find("F1:"), std::string::npos);
  EXPECT_LT(text.find("F1:"), text.find("F0:"));
  EXPECT_EQ(made.report.counters[ArmAxis::z], 300);
  EXPECT_EQ(made.report.triplets, 0U);
}

TEST(PatternMaker, TheWheelTurnsInTheAirBeforeACutAndAtSharpCorners) {
  const auto definition = machine_with("cartesian-step");
  const Made made =
      made_of("G00Z5.\nX100.Y50.\nG01Z-.1F60.\nX110.\nX120.Y51.\nX120.Y70.\n", definition);
  EXPECT_EQ(listed(made.records), "F3:500 F1:5000 F0:10000 F3:-510 S F3:210 F2:112 F3:-210 S ");
  EXPECT_EQ(made.report.lifts, 1U);
}

TEST(PatternMaker, ACornerOfACutAsHighAsTheTravelIsTurnedAboveIt) {
  const char* const corner = "X120.\nY70.\n";
  for (const char* const z : {"2.", "19.9"}) {
    const std::string program = "G00Z30.\nX100.Y50.\nG01Z" + std::string(z) + "F60.\n" + corner;
    const Made made = made_of(program, "cartesian-step");
    EXPECT_TRUE(listed(made.records).ends_with("S F3:200 F2:-120 F3:-200 S ")) << z;
    EXPECT_EQ(made.report.lifts, 1U);
  }
  // Below it the height of travel is what is clear, however near.
  const Made low =
      made_of(std::string("G00Z30.\nX100.Y50.\nG01Z1.9F60.\n") + corner, "cartesian-step");
  EXPECT_TRUE(listed(low.records).ends_with("S F3:10 F2:-120 F3:-10 S "));
}

TEST(PatternMaker, ARapidFromACutAsHighAsTheTravelIsMadeAboveIt) {
  const std::string cut = "G00Z30.\nX100.Y50.\nG01Z19.9F60.\nX120.\n";
  const Made along = made_of(cut + "G00X150.\n", "cartesian-step");
  EXPECT_TRUE(listed(along.records).ends_with("S F3:200 F0:3000 F3:-200 "));
  const Made above = made_of(cut + "G01Z25.\nG00X150.\n", "cartesian-step");
  EXPECT_TRUE(listed(above.records).ends_with("S F3:510 F0:3000 "));
}

TEST(PatternMaker, ALiftThatTheMachineCannotMakeIsAnAlarmOfItsLine) {
  const std::string program = "G00Z30.\nX150.Y50.\nG01Z19.9F60.\nX170.\nY70.\nM30\n";
  auto low = machine_with("arm4");
  low.driven[3].travel_high = 21.8;
  const Made beyond = made_of("G00Z20.\nX150.Y50.\nG01Z19.9F60.\nX170.\nY70.\n", low);
  ASSERT_TRUE(beyond.alarm);
  EXPECT_EQ(beyond.alarm->code, base::Code::joint_limit);
  EXPECT_EQ(beyond.alarm->place.line, 7U);
  const Made none = made_of(program, machine_with("arm4", {{"pattern.travel_z", "0"}}));
  ASSERT_TRUE(none.alarm);
  EXPECT_EQ(none.alarm->code, base::Code::pattern_motion);
  EXPECT_EQ(none.alarm->place.line, 7U);
}

TEST(PatternMaker, APlungeInStepsWaitsForTheHeading) {
  for (const char* const between : {"", "G04P500\n", "Z-.15\nG04P500\n"}) {
    const Made made =
        made_of("G00Z2.\nX100.Y50.\nG01Z-.1F60.\n" + std::string(between) + "Z-.2\nY60.\n",
                "cartesian-step");
    EXPECT_EQ(listed(made.records), "F3:200 F1:5000 F0:10000 F2:-120 F3:-220 S ") << between;
    EXPECT_EQ(made.report.lifts, 0U);
    EXPECT_EQ(made.report.dwells, *between == '\0' ? 0U : 1U);
  }
}

// Also where the wheel stands in the work: it is lifted, turned, and comes down to the new depth.
TEST(PatternMaker, APlungeInACornerIsMadeBehindTheTurn) {
  const Made made =
      made_of("G00Z2.\nX100.Y50.\nG01Z-.1F60.\nX110.\nZ-.2\nZ-.3\nY60.\n", "cartesian-step");
  EXPECT_TRUE(listed(made.records).ends_with("S F3:210 F2:-120 F3:-230 S "));
}

TEST(PatternMaker, WhereTheWheelHasNotToTurnItIsNotLifted) {
  const Made made = made_of("G00Z2.\nX100.Y50.\nG01Z-.1F60.\nX110.\nX120.Y50.01\nX130.\n",
                            machine_with("cartesian-step", {{"pattern.tangent_jump_deg", "0"}}));
  EXPECT_EQ(made.report.lifts, 0U);
}

TEST(PatternMaker, ACutOfTheLiftAloneIsAFastRecord) {
  const Made made =
      made_of("G00Z5.\nX100.Y50.\nG01Z-1.F60.\nG01Z2.\nG01Z-2.\nG00Z5.\n", "cartesian-step");
  EXPECT_EQ(listed(made.records), "F3:500 F1:5000 F0:10000 F3:-600 F3:300 F3:-400 F3:700 ");
}

TEST(PatternMaker, WhatRecordsCannotHoldIsAnAlarmOfItsLine) {
  struct Row {
    const char* program;
    base::Code code;
    std::uint32_t line;
  };
  const Row rows[] = {
      {"G00X100.Y50.\nG01X110.Z-.2F60.\n", base::Code::pattern_motion, 4},
      {"G00X100.Y50.\nG03X110.Y60.Z-1.R10.F60.\n", base::Code::pattern_motion, 4},
      {"G00X100.Y50.\nG31X110.F60.\n", base::Code::pattern_motion, 4},
  };
  for (const Row& row : rows) {
    const Made made = made_of(row.program);
    ASSERT_TRUE(made.alarm) << row.program;
    EXPECT_EQ(made.alarm->code, row.code);
    EXPECT_EQ(made.alarm->place.line, row.line);
  }
}

TEST(PatternMaker, WhatTheTimersCannotDoIsAnAlarmOfItsLine) {
  const Made made = made_of(kCircle, machine_with("arm4", {{"drive.split", "integer"}}));
  ASSERT_TRUE(made.alarm);
  EXPECT_EQ(made.alarm->code, base::Code::timer_overflow);
  EXPECT_EQ(made.alarm->place.line, 6U);
}

TEST(PatternMaker, AProgramMayGiveTheHeadingItself) {
  const Made made = made_of("G00Z5.\nX100.Y50.C90.\nG01Z-.1F60.\nX110.C120.\n",
                            machine_with("cartesian-step", {{"pattern.heading", "program"}}));
  const double wheel_deg = static_cast<double>(made.report.counters[ArmAxis::theta3]) * 0.75;
  EXPECT_NEAR(std::remainder(wheel_deg - 120, 180), 0, 1.5);  // where the last step begins
  EXPECT_FALSE(made.alarm);
}

// Random contours: everything that the format promises, at once.
TEST(PatternProperty, RandomContoursKeepTheirBoundAndHeading) {
  test::SeededRandom random(test::kSeed + 4);
  for (int i = 0; i < 12; ++i) {
    const double x = random.in(60, 150);
    const double y = random.in(-80, 80);
    const double r = random.size(0.5, 30);
    const auto number = [](double v) { return std::to_string(v); };
    const std::string program = "G00Z5.\nX" + number(x + r) + "Y" + number(y) +
                                "\nG01Z-.1F60.\nG03I-" + number(r) + "F78.\n";
    const auto definition = machine_with(i % 3 == 0 ? "cartesian-step" : "arm4");
    const Made made = made_of(program, definition);
    ASSERT_FALSE(made.alarm) << program;
    for (const PatternRecord& record : made.records) {
      const auto* const triplet = std::get_if<Triplet>(&record);
      if (triplet == nullptr) continue;
      for (const drive::PulseField& field : triplet->fields) ASSERT_LE(field.pulses, 30);
    }
    const auto round3 = [](double v) { return std::round(v * 1000) / 1000; };
    const double off = measured(made, definition, [&](const TipPoint& tip) {
      return from_circle(tip, round3(x + r) - round3(r), round3(y), round3(r));
    });
    EXPECT_LE(off, made.report.bound.mm + 1e-9) << program;
    EXPECT_NEAR(off, made.report.measured.mm, 1e-6) << program;
    EXPECT_LE(made.report.heading_deg, 0.375 + 1e-9);
  }
}

// Between the triplets of a circle the wheel is off the tangent by half a step, and within one by
// what tangent and arms turn on the way.
TEST(PatternMaker, TheWheelStaysOnTheTangent) {
  const auto definition = machine_with("arm4");
  const auto motors = *PatternMachine::of(definition);
  const Made made = made_of(kCircle, definition);
  ArmCounts at;
  double worst_deg = 0;
  for (const PatternRecord& record : made.records) {
    if (const auto* const fast = std::get_if<FastRecord>(&record)) {
      at[fast->axis] += fast->move().count;
      continue;
    }
    const drive::SlowMove move = std::get<Triplet>(record).move();
    at[ArmAxis::theta3] += move.theta3;
    const TipPoint tip = motors.tip_at(at);
    const double tangent =
        geometry::degrees(std::atan2(tip[motors.y()] - 60, tip[motors.x()] - 150)) + 90;
    const double off = std::remainder(tip[motors.c()] - tangent, 180);
    worst_deg = std::max(worst_deg, std::fabs(off));
    at[ArmAxis::theta1] += move.theta1;
    at[ArmAxis::theta2] += move.theta2;
  }
  EXPECT_LE(worst_deg, 0.375 + 0.05);  // a sample is off by a pulse, 0.03 degrees around the centre
  EXPECT_GT(worst_deg, 0.3);
}

}  // namespace
}  // namespace kerf::engraver
