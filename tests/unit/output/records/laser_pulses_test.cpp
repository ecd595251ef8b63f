// Power along set-points: motions go to the servo by hand.
#include "output/records/laser_pulses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "machine/run/batch_run.hpp"
#include "machine/run/servo.hpp"
#include "output/writing/drive_alarm.hpp"
#include "temporary_folder.hpp"

namespace kerf::output {
namespace {

using motion::Feed;
using motion::Line;
using motion::Power;
using motion::Rapid;

constexpr double kFeed = 1500;  // mm/min: 25 mm/s

/// What a laser writes for motions, one a line of the program, which is "L1", "L2" and so on.
class Laser {
 public:
  using Keys = std::vector<std::pair<std::string, std::string>>;
  explicit Laser(const Keys& keys = {}, const std::string& name = "laser3") {
    machine::MachineDefinition definition = *machine::find_machine(name);
    for (const auto& [key, value] : keys) EXPECT_TRUE(definition.set(key, value));
    machine_.emplace(definition, control::Memory(definition.parameters.n_offsets));
    std::string program;
    for (int line = 1; line < 20; ++line) program += "L" + std::to_string(line) + "\n";
    machine_->load(base::SourceFile::from_text("part.nc", program));
  }

  std::string rows(const std::vector<motion::Motion::Action>& actions) {
    const test::TemporaryFolder folder;
    auto file = std::move(*base::OutputFile::create(folder / "pwm.csv"));
    const auto fault = [this](const base::Diagnostic& alarm, const motion::Mark& mark) {
      machine_->raise(at_mark(alarm, mark, machine_->sources()));
    };
    LaserPulses pulses(machine_->definition().drive.laser, fault, *file);
    machine::Servo servo(machine_->definition());
    servo.add_sink(pulses);
    for (std::uint32_t line = 1; line <= actions.size(); ++line) {
      servo.take(
          {.block = {.program = base::ProgramNumber{7}, .file = base::FileId{0}, .line = line},
           .action = actions[line - 1]});
    }
    servo.finish();
    pulses.finish();
    EXPECT_TRUE(file->commit());
    const std::string text = folder.read("pwm.csv");
    const std::string header = "t,line,f,duty,TCNTB,TCMPB\n";
    EXPECT_EQ(text.substr(0, header.size()), header);
    return text.substr(header.size());
  }
  machine::BatchRun& machine() { return *machine_; }

 private:
  std::optional<machine::BatchRun> machine_;
};

// Whole milliseconds of a move from rest to rest that reaches its velocity; 3000 mm/s².
double seconds(double length_mm, double velocity_mm_s) {
  return std::ceil((length_mm / velocity_mm_s + velocity_mm_s / 3000) * 1000 - 1e-6) / 1000;
}

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(LaserPulses, ARowForEachChangeAtTheStandstillWhereItIsMade) {
  Laser laser;
  const std::string rows =
      laser.rows({Rapid{{50}}, Power{80}, Line{{60}, Feed{kFeed}}, Power{}, Rapid{{110}}, Power{50},
                  motion::Dwell{0.25}, Power{0}, Rapid{{60}}});
  const double rapid_s = seconds(50, 100);
  const double on_s = rapid_s + seconds(10, 25);
  const double again_s = on_s + rapid_s;
  EXPECT_EQ(rows, "0,1,2000,0,12500,0\n" +                           //
                      text(rapid_s) + ",3,2000,0.8,12500,10000\n" +  //
                      text(on_s) + ",5,2000,0,12500,0\n" +           //
                      text(again_s) + ",7,2000,0.5,12500,6250\n" +   //
                      text(again_s + 0.25) + ",9,2000,0,12500,0\n");
}

TEST(LaserPulses, TheBeamGoesOffWithTheRun) {
  Laser laser;
  EXPECT_EQ(laser.rows({Power{20}, Line{{10}, Feed{kFeed}}}),
            "0,2,2000,0.2,12500,2500\n" + text(seconds(10, 25)) + ",2,2000,0,12500,0\n");
}

TEST(LaserPulses, PowerThatChangesUnderWayChangesWithinAPeriodOfThere) {
  Laser laser;
  std::istringstream rows(
      laser.rows({Power{20}, Line{{10}, Feed{kFeed}}, Power{100}, Line{{20}, Feed{kFeed}}}));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "0,2,2000,0.2,12500,2500");
  std::getline(rows, row);
  EXPECT_EQ(row.substr(row.find(',')), ",4,2000,1,12500,12500");
  const double reached_s = 10.0 / 25 + 25.0 / 3000 / 2;
  EXPECT_GT(std::stod(row), reached_s - 0.001 - 1e-9);
  EXPECT_LE(std::stod(row), reached_s);
}

TEST(LaserPulses, PercentAreWhatWasCommanded) {
  Laser laser;
  EXPECT_EQ(laser.rows({Power{33.3}, motion::Dwell{0.5}}),
            "0,2,2000,0.333,12500,4163\n0.5,2,2000,0,12500,0\n");
}

TEST(LaserPulses, RegistersAreThoseOfTheMachineFile) {
  Laser inverted(
      Laser::Keys{{"drive.output", "active_before_match"}, {"drive.pwm_frequency_hz", "37000"}});
  EXPECT_EQ(inverted.rows({Power{80}, motion::Dwell{0.5}}),
            "0,2,37000,0.8,676,135\n0.5,2,37000,0,676,676\n");
  Laser slow(
      {{"drive.prescaler", "49"}, {"drive.divider", "16"}, {"drive.pwm_frequency_hz", "100"}},
      "laser5");
  EXPECT_EQ(slow.rows({Power{35}, motion::Dwell{0.8}}),
            "0,2,100,0.35,625,219\n0.8,2,100,0,625,0\n");
}

TEST(LaserPulses, AProgramMaySayTheFrequency) {
  Laser laser;
  Power slow{50};
  slow.frequency_hz = 500;
  Power off{0};
  off.frequency_hz = 500;
  EXPECT_EQ(laser.rows(
                {slow, motion::Dwell{0.5}, off, motion::Dwell{0.5}, Power{50}, motion::Dwell{0.5}}),
            "0,2,500,0.5,50000,25000\n0.5,4,500,0,50000,0\n1,6,2000,0.5,12500,6250\n"
            "1.5,6,2000,0,12500,0\n");
}

TEST(LaserPulses, AFrequencyThatNoTimerMakesIsAnAlarmAtItsLine) {
  Laser laser;
  Power slow{50};
  slow.frequency_hz = 300;
  laser.rows({Rapid{{10}}, slow, motion::Dwell{0.5}});
  EXPECT_EQ(laser.machine().run_to_end(), machine::RunStatus::alarm);
  EXPECT_EQ(laser.machine().alarm()->number, "PWM_RANGE");
  EXPECT_EQ(laser.machine().alarm()->place.line, 3U);
}

TEST(LaserPulses, APowerThatNoTimerMakesIsAnAlarmAtItsLine) {
  Laser laser;
  const std::string rows = laser.rows({Rapid{{10}}, Power{120}, motion::Dwell{0.5}});
  EXPECT_EQ(rows.find("1.2"), std::string::npos) << rows;
  EXPECT_EQ(laser.machine().run_to_end(), machine::RunStatus::alarm);
  const base::Diagnostic& alarm = *laser.machine().alarm();
  EXPECT_EQ(alarm.number, "PWM_RANGE");
  EXPECT_EQ(alarm.place.line, 3U);
  EXPECT_EQ(alarm.place.line_start, 6U);  // behind "L1\nL2\n"
  EXPECT_EQ(alarm.program, "O0007");
  EXPECT_NE(alarm.message.find("the duty is 1.2"), std::string::npos) << alarm.message;
}

}  // namespace
}  // namespace kerf::output
