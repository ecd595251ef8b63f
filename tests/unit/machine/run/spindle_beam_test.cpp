#include "machine/run/spindle_beam.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace kerf::machine {
namespace {

using motion::Spindle;

// What the machine does for the motions, a word each: the power and whether the beam has it.
class Beam {
 public:
  explicit Beam(double s_of_full_power = 1000) : beam_(laser(s_of_full_power)) {}

  std::string take(const motion::Motion::Action& action, std::uint32_t line = 1) {
    std::string told;
    for (const motion::Motion& motion :
         beam_.translated({.block = {.line = line}, .action = action})) {
      EXPECT_EQ(motion.block.line, line);
      if (!told.empty()) told += ' ';
      told += word(motion.action);
    }
    return told;
  }
  std::string cut() { return take(motion::Line{}); }
  std::string rapid() { return take(motion::Rapid{}); }
  std::string cw(double s) { return take(Spindle{.turning = Turning::clockwise, .speed = s}); }
  std::string ccw(double s) {
    return take(Spindle{.turning = Turning::counterclockwise, .speed = s});
  }
  std::string stop() { return take(Spindle{.turning = Turning::stopped}); }

  SpindleBeam& operator*() { return beam_; }

 private:
  using Turning = Spindle::Turning;

  static LaserSettings laser(double s_of_full_power) {
    LaserSettings laser;
    laser.max_power_w = 60;
    laser.s_of_full_power = s_of_full_power;
    return laser;
  }
  static std::string word(const motion::Motion::Action& action) {
    if (std::holds_alternative<motion::Rapid>(action)) return "G0";
    if (std::holds_alternative<motion::Line>(action)) return "G1";
    if (std::holds_alternative<Spindle>(action)) return "S";
    const auto* const power = std::get_if<motion::Power>(&action);
    if (power == nullptr) return "-";
    EXPECT_TRUE(power->on);
    return "on" + std::to_string(static_cast<int>(power->percent)) +
           (power->follows_speed ? "f" : "");
  }

  SpindleBeam beam_;
};

TEST(SpindleBeam, IsOnInCutsAndOffInRapids) {
  Beam beam;
  EXPECT_EQ(beam.cut(), "G1");
  EXPECT_EQ(beam.cw(500), "");
  EXPECT_EQ(beam.rapid(), "G0");
  EXPECT_EQ(beam.cut(), "on50 G1");
  EXPECT_EQ(beam.cut(), "G1");
  EXPECT_EQ(beam.take(motion::Arc{}), "-");
  EXPECT_EQ(beam.take(motion::Dwell{}), "-");
  EXPECT_EQ(beam.rapid(), "on0 G0");
  EXPECT_EQ(beam.take(motion::SpaceArc{}), "on50 -");
  EXPECT_EQ(beam.stop(), "on0");
  EXPECT_EQ(beam.stop(), "");
  EXPECT_EQ(beam.cut(), "G1");
}

TEST(SpindleBeam, ChangesItsPowerWithoutGoingOff) {
  Beam beam(255);
  beam.cw(51);
  EXPECT_EQ(beam.cut(), "on20 G1");
  EXPECT_EQ(beam.cw(255), "on100");
  EXPECT_EQ(beam.cw(0), "on0");
  EXPECT_EQ(beam.cut(), "G1");
  EXPECT_EQ(beam.ccw(102), "on40f");
  EXPECT_EQ(beam.rapid(), "on0 G0");
}

TEST(SpindleBeam, IsOffWhereTheMachineStopsAndWhenTheProgramEnds) {
  Beam beam;
  beam.cw(1000);
  beam.cut();
  EXPECT_EQ(beam.take(motion::Stop{}), "on0 -");
  EXPECT_EQ(beam.cut(), "on100 G1");
  EXPECT_EQ(beam.take(motion::Probe{}), "on0 -");
  beam.cut();
  EXPECT_EQ(beam.take(motion::End{}), "on0 -");
  EXPECT_EQ(beam.cut(), "G1");
  beam.cw(1000);
  beam.cut();
  (*beam).reset();
  EXPECT_EQ(beam.cut(), "G1");
  EXPECT_EQ(beam.take(Spindle{.turning = Spindle::Turning::oriented}), "");
}

TEST(SpindleBeam, HasFullPowerAboveThatAndSaysSoOnce) {
  Beam beam;
  beam.cw(1000);
  EXPECT_FALSE((*beam).warning());
  EXPECT_EQ(beam.cut(), "on100 G1");
  EXPECT_EQ(beam.take(Spindle{.turning = Spindle::Turning::clockwise, .speed = 1200}, 7), "on100");
  EXPECT_EQ(beam.take(Spindle{.turning = Spindle::Turning::clockwise, .speed = 1500}, 8), "on100");
  ASSERT_TRUE((*beam).warning());
  EXPECT_EQ((*beam).warning()->place.line, 7U);
  EXPECT_THAT((*beam).warning()->message, testing::HasSubstr("S1200, full power is S1000"));
}

TEST(SpindleBeam, OfAMachineWithoutALaserIsASpindle) {
  SpindleBeam beam(LaserSettings{});
  const motion::Motion motion{.action = Spindle{.turning = Spindle::Turning::clockwise}};
  ASSERT_EQ(beam.translated(motion).size(), 1U);
  EXPECT_EQ(beam.translated(motion).data(), &motion);
}

TEST(SpindleBeam, ACutWithoutAWayTurnsTheBeamOnWhereItStands) {
  Beam beam;
  EXPECT_EQ(beam.cw(500), "");
  EXPECT_EQ(beam.rapid(), "G0");
  const Spindle standing{
      .turning = Spindle::Turning::clockwise, .speed = 500, .cuts_standing = true};
  EXPECT_EQ(beam.take(standing, 7), "on50");
  EXPECT_EQ(beam.take(standing), "");
  beam.take(motion::Dwell{1}, 8);
  EXPECT_FALSE((*beam).dwell_warning());
  beam.rapid();
  beam.take(motion::Dwell{1}, 9);
  ASSERT_TRUE((*beam).dwell_warning());
  EXPECT_EQ((*beam).dwell_warning()->place.line, 9U);
}

}  // namespace
}  // namespace kerf::machine
