#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "drive/pattern/listing.hpp"
#include "drive/pattern/record.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/pattern_motors.hpp"
#include "machine/run/pulse_lines.hpp"
#include "machine/run/run_statistics.hpp"
#include "motion/axis_point.hpp"
#include "motion/motion.hpp"

namespace kerf::engraver {

/// Runs the records of a pattern on the motors of a machine that stands where every counter is 0.
///
/// Pulses go to the pulse sinks. Motions: a line of the tip for each triplet or linked move, at
/// the feed that it has, a rapid for each fast record; what moves nothing is none. Set-points: one
/// for every period of the servo, joints on the straight lines that the pulses follow, up to the
/// first period at which all stands. `line` of both is the number of the record, from 1.
class PatternReplay {
 public:
  /// The machine must outlive the replay. Sinks are added before the first record.
  explicit PatternReplay(const machine::PatternMachine& machine);
  PatternReplay(const PatternReplay&) = delete;
  PatternReplay& operator=(const PatternReplay&) = delete;

  void add_sink(drive::PulseSink& sink) { pulses_.sinks.push_back(&sink); }
  void add_sink(motion::MotionSink& sink) { motions_.push_back(&sink); }
  void add_sink(motion::AxisPointSink& sink) {
    if (points_.empty()) add_sink(static_cast<drive::PulseSink&>(lines_));
    points_.push_back(&sink);
  }

  /// Asked every few milliseconds of computing while set-points are made; true: none is made any
  /// more, and no record should follow.
  void break_off_when(std::function<bool()> question) { broken_off_when_ = std::move(question); }
  [[nodiscard]] bool broken_off() const { return broken_off_; }

  /// Makes the next record. Error TIMER_OVERFLOW: nothing of it has moved.
  [[nodiscard]] base::Result<void> take(const drive::PatternRecord& record);
  /// All four motors together (machine::PatternSettings::Link::four).
  [[nodiscard]] base::Result<void> take(const drive::ListedLinked& linked);
  /// The end: the last set-points.
  void finish();

  [[nodiscard]] const machine::PatternMachine& machine() const { return machine_; }

  struct Totals {
    std::uint64_t fast = 0;  ///< records
    std::uint64_t triplets = 0;
    std::uint64_t linked = 0;
    std::uint64_t pulses = 0;

    [[nodiscard]] std::uint64_t records() const { return fast + triplets + linked; }
  };
  [[nodiscard]] const Totals& totals() const { return totals_; }
  [[nodiscard]] const drive::ArmCounts& counters() const { return motors_.counters(); }
  [[nodiscard]] double time_s() const { return motors_.time_s(); }
  [[nodiscard]] const machine::RunStatistics& statistics() const { return statistics_; }
  /// A joint that has stood beyond its travel behind a record, from 1.
  struct BeyondTravel {
    std::string sentence;
    std::uint64_t record = 0;
  };
  /// The first such place of each joint, in the order of the records.
  [[nodiscard]] const std::vector<BeyondTravel>& beyond_travel() const { return beyond_travel_; }

 private:
  struct Fan : drive::PulseSink {
    void take(const drive::Pulse& pulse) override;
    std::vector<drive::PulseSink*> sinks;
    std::uint64_t count = 0;
  };

  [[nodiscard]] std::uint64_t records() const { return totals_.records(); }
  /// What `make` does on the motors is a record that `count` counts.
  template <typename Make>
  base::Result<void> follow(std::uint64_t& count, const Make& make);
  void tell_motion();
  void sample(double begin_s, double end_s);
  void look_at_travel();

  const machine::PatternMachine& machine_;
  Fan pulses_;
  machine::PatternMotors motors_;
  machine::PulseLines lines_;
  machine::RunStatistics statistics_;
  std::vector<motion::MotionSink*> motions_;
  std::vector<motion::AxisPointSink*> points_;
  std::uint64_t period_ = 0;  // of the servo, made so far
  Totals totals_;
  std::vector<BeyondTravel> beyond_travel_;
  std::array<bool, drive::kArmAxes> is_beyond_{};  // joints that are in beyond_travel_
  std::function<bool()> broken_off_when_;
  bool broken_off_ = false;
};

}  // namespace kerf::engraver
