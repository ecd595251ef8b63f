#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "allocation_count.hpp"
#include "drive/arm_drive.hpp"
#include "drive/pulse_csv.hpp"
#include "drive/pulse_vcd.hpp"
#include "drive/step_generator.hpp"
#include "drive_recorder.hpp"
#include "seeded_random.hpp"
#include "temporary_folder.hpp"

namespace kerf::drive {
namespace {

using test::PulseRecorder;
using test::TemporaryFolder;

constexpr std::int64_t kSetup = 5000;
const std::vector<std::string> kNames{"X", "Y"};

/// What a logic analyser sees in a value change dump.
struct VcdReader {
  std::vector<Pulse> pulses;  // in the order of their rising edges
  std::map<std::string, std::int64_t> turned_ns;
  bool in_order = true;
  bool settled = true;  // every direction stood long enough before its pulse, and while it was high

  explicit VcdReader(const std::string& text) {
    std::istringstream in(text);
    for (std::string word; in >> word;) {
      if (word == "$timescale") {
        std::string number;
        std::string unit;
        in >> number >> unit >> word;
        if (number + unit != "1ns") throw std::runtime_error("timescale " + number + unit);
      } else if (word == "$var") {
        std::string kind;
        std::string width;
        std::string code;
        std::string name;
        in >> kind >> width >> code >> name >> word;
        if (kind + width != "wire1" || word != "$end") throw std::runtime_error("$var");
        names_[code] = name;
      } else if (word == "$scope") {
        in >> word >> word >> word;
      } else if (word[0] == '#') {
        const std::int64_t time = std::stoll(word.substr(1));
        in_order = in_order && (time > now_ || time == 0);
        now_ = time;
      } else if (word[0] == '0' || word[0] == '1') {
        change(names_.at(word.substr(1)), word[0] == '1');
      }
    }
  }

 private:
  void change(const std::string& wire, bool high) {
    const std::string axis = wire.substr(0, wire.find('_'));
    if (wire == axis + "_dir") {
      settled = settled && !level_[axis + "_step"];
      if (level_.count(wire) != 0) turned_ns[axis] = now_;
    } else if (high) {
      if (turned_ns.count(axis) != 0) settled = settled && now_ - turned_ns[axis] >= kSetup;
      open_[axis] = pulses.size();
      const auto position = std::find(kNames.begin(), kNames.end(), axis) - kNames.begin();
      pulses.push_back({now_, 0, static_cast<base::Axis>(position),
                        level_[axis + "_dir"] ? Direction::positive : Direction::negative});
    } else if (level_[wire]) {
      Pulse& pulse = pulses[open_[axis]];
      pulse.width_ns = static_cast<std::uint32_t>(now_ - pulse.time_ns);
    }
    level_[wire] = high;
  }

  std::map<std::string, std::string> names_;
  std::map<std::string, bool> level_;
  std::map<std::string, std::size_t> open_;
  std::int64_t now_ = 0;
};

std::string vcd_of(const std::vector<Pulse>& pulses, std::int64_t setup_ns = kSetup) {
  const TemporaryFolder folder;
  auto file = std::move(*base::OutputFile::create(folder / "pulses.vcd"));
  PulseVcd vcd(kNames, setup_ns, *file);
  for (const Pulse& pulse : pulses) vcd.take(pulse);
  vcd.finish();
  EXPECT_TRUE(file->commit());
  return folder.read("pulses.vcd");
}

/// Pulses of a walk that turns round often.
std::vector<Pulse> random_pulses() {
  test::SeededRandom random(test::kSeed);
  PulseRecorder recorder;
  StepTiming timing;
  timing.direction_setup_ns = kSetup;
  timing.band_steps = 0.25;
  StepGenerator generator({{"X", 100, 0}, {"Y", 100, 0}}, timing, recorder);
  JointMoment point;
  generator.start(point);
  for (int i = 1; i <= 3000; ++i) {
    point.time_s = i * 1e-3;
    point.joints.values[0] += random.in(-0.2, 0.2);
    point.joints.values[1] += random.in(-0.2, 0.2);
    EXPECT_TRUE(generator.move_to(point));
  }
  return recorder.pulses;
}

TEST(PulseCsv, ALineForEachPulse) {
  const TemporaryFolder folder;
  auto file = std::move(*base::OutputFile::create(folder / "pulses.csv"));
  PulseCsv csv({"T1", "T2"}, *file);
  csv.take({0, 1, base::Axis{0}, Direction::positive});
  csv.take({123'456'789'012, 1, base::Axis{1}, Direction::negative});
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(folder.read("pulses.csv"), "time_ns,axis,direction\n0,T1,1\n123456789012,T2,-1\n");
}

TEST(PulseVcd, AStepAndADirectionWireForEachAxis) {
  EXPECT_EQ(vcd_of({{10'000, 2500, base::Axis{0}, Direction::positive},
                    {12'000, 2500, base::Axis{1}, Direction::negative},
                    {20'000, 2500, base::Axis{0}, Direction::negative}}),
            "$timescale 1 ns $end\n$scope module kerf $end\n"
            "$var wire 1 ! X_step $end\n$var wire 1 \" X_dir $end\n"
            "$var wire 1 # Y_step $end\n$var wire 1 $ Y_dir $end\n"
            "$upscope $end\n$enddefinitions $end\n"
            "#0\n$dumpvars\n0!\n1\"\n0#\n1$\n$end\n"
            "#7000\n0$\n#10000\n1!\n#12000\n1#\n#12500\n0!\n#14500\n0#\n#15000\n0\"\n#20000\n1!\n"
            "#22500\n0!\n");
}

TEST(PulseVcd, ReadsBackAsThePulsesThatWereWritten) {
  const std::vector<Pulse> pulses = random_pulses();
  ASSERT_GT(pulses.size(), 10'000U);
  const VcdReader reader(vcd_of(pulses));
  EXPECT_TRUE(reader.in_order);
  EXPECT_TRUE(reader.settled);
  EXPECT_TRUE(reader.pulses == pulses);
}

TEST(PulseVcd, ReadsBackTheArmsPulses) {
  test::SeededRandom random(test::kSeed);
  PulseRecorder recorder;
  ArmDrive drive({}, recorder);
  for (int i = 0; i < 200; ++i)
    ASSERT_TRUE(drive.slow({0, random.count(-30, 30), random.count(-30, 30)}));
  const VcdReader reader(vcd_of(recorder.pulses));
  EXPECT_TRUE(reader.in_order);
  EXPECT_TRUE(reader.settled);
  EXPECT_TRUE(reader.pulses == recorder.pulses);
}

TEST(PulseVcd, AFirstPulseWithoutRoomTurnsItsDirectionAtTheStart) {
  const VcdReader reader(vcd_of({{100, 10, base::Axis{0}, Direction::negative}}));
  ASSERT_EQ(reader.pulses.size(), 1U);
  EXPECT_EQ(reader.pulses[0].direction, Direction::negative);
}

TEST(PulseWriters, AllocateNothing) {
  const std::vector<Pulse> pulses = random_pulses();
  const auto file = std::move(*base::OutputFile::create("/dev/null"));
  PulseCsv csv(kNames, *file);
  PulseVcd vcd(kNames, kSetup, *file);
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    if (i == pulses.size() / 4) before = test::allocations_so_far();
    csv.take(pulses[i]);
    vcd.take(pulses[i]);
  }
  // The file's buffer may grow a last time.
  EXPECT_LE(test::allocations_so_far(), before + 1);
}

}  // namespace
}  // namespace kerf::drive
