#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/point.hpp"
#include "base/result.hpp"
#include "drive/pulse_sink.hpp"

namespace kerf::drive {

/// One axis with a step motor.
struct StepAxis {
  std::string name;           ///< the machine file's, for messages
  double steps_per_unit = 1;  ///< per mm or degree; not 0; negative turns the motor round
  double most_rate_hz = 0;    ///< fastest steps, 1/s; 0: only StepTiming limits them
};

/// What the inputs of the motors' amplifiers need. All in ns.
struct StepTiming {
  std::int64_t pulse_width_ns = 2500;      ///< high time of a pulse, 1 to 2^32-1
  std::int64_t pulse_gap_ns = 2500;        ///< low time before the next one, >= 1
  std::int64_t direction_setup_ns = 5000;  ///< from a change of direction to the rising edge, >= 0

  /// The count changes when the line is this much more than half a step away, in steps, in
  /// [0, 0.25]. It keeps an axis that rests between two steps from chattering over rounding errors,
  /// and holds the two steps of a reversal 2 * band / rate apart.
  double band_steps = 1e-6;
};

/// Where the joints must be at a moment, in the units of the axes (mm, degrees).
struct JointMoment {
  double time_s = 0;
  base::JointPoint joints;
};

/// Turns set-points into step pulses (docs/drives.md, "Steps along a line").
///
/// Between two set-points each joint moves on a straight line over time, and its motor steps at the
/// moment the line is half a step away from the count (and StepTiming::band_steps). So
/// - the count is never more than 1/2 + band_steps of a step from the line, but for the rounding of
///   each pulse, by itself, to a whole ns;
/// - after a set-point the count is the number of steps nearest to it; a tie within band_steps
///   stays where it was;
/// - nothing adds up, however many set-points there are.
///
/// Pulses leave in the order of their times; at the same ns in the order of the axes. Memory does
/// not grow; nothing is allocated but for the text of an error.
class StepGenerator {
 public:
  /// At most base::kMaxAxes axes. The sink must outlive the generator.
  StepGenerator(std::vector<StepAxis> axes, const StepTiming& timing, PulseSink& sink);

  /// The machine stands here: sets the counters to the nearest steps, makes no pulse.
  void start(const JointMoment& point);

  /// Makes the pulses of the line from the last set-point to this one, whose time is not before.
  /// Error STEP_RATE, naming axis, time and rate: steps would follow one another faster than the
  /// axis or its amplifier takes them (to within 1 ns), a reversal leaves no time for the direction
  /// to settle, or a position lies beyond 2^40 steps. Then no pulse of this line is made, and
  /// the generator stands where it stood.
  [[nodiscard]] base::Result<void> move_to(const JointMoment& point);

  /// Steps from joint position 0, after the pulses made so far.
  [[nodiscard]] std::int64_t count(base::Axis axis) const { return state_[index(axis)].count; }

 private:
  struct AxisState {
    double position = 0;  // of the last set-point, steps
    std::int64_t count = 0;
    std::int64_t last_rise_ns = 0;
    Direction last_direction = Direction::positive;
    bool has_stepped = false;
  };

  // The evenly spaced pulses of one axis between two set-points.
  struct Train {
    std::int64_t next_ns = 0;
    double first_steps = 0;  // from the start of the line to the first pulse
    double ns_per_step = 0;
    double index = 0;  // of the next pulse
    double pulses = 0;
    Pulse pulse;
  };

  [[nodiscard]] Train train_of(std::size_t axis, double target, double duration_ns) const;
  [[nodiscard]] base::Result<void> check(std::size_t axis, const Train& train) const;
  void emit(std::size_t trains, double duration_ns);
  [[nodiscard]] std::int64_t time_of(const Train& train, double duration_ns) const;

  std::vector<StepAxis> axes_;
  StepTiming timing_;
  double reach_;  // distance from the count at which the motor steps, steps
  PulseSink& sink_;
  std::int64_t now_ns_ = 0;  // of the last set-point
  std::array<AxisState, base::kMaxAxes> state_{};
  std::array<Train, base::kMaxAxes> trains_{};
};

}  // namespace kerf::drive
