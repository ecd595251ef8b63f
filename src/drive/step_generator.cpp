#include "drive/step_generator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::drive {
namespace {

constexpr double kMostSteps = 1099511627776.0;  // 2^40: a double still resolves the band there

std::int64_t nanoseconds(double time_s) { return base::round_away(time_s * 1e9); }

base::unexpected<base::Diagnostic> no_step(const std::string& sentence) {
  return base::unexpected(base::make_error(base::Code::step_rate, {}, sentence));
}

std::string at(const StepAxis& axis, std::int64_t time_ns) {
  return "axis " + axis.name + " at " + base::number_text(static_cast<double>(time_ns) / 1e9) +
         " s: ";
}

std::string rate_text(double interval_ns) {
  if (interval_ns <= 0) return "two steps at once";
  return base::number_text(std::round(1e9 / interval_ns)) + " steps/s";
}

}  // namespace

StepGenerator::StepGenerator(std::vector<StepAxis> axes, const StepTiming& timing, PulseSink& sink)
    : axes_(std::move(axes)), timing_(timing), reach_(0.5 + timing.band_steps), sink_(sink) {
  assert(axes_.size() <= base::kMaxAxes);
  assert(timing.pulse_width_ns >= 1 && timing.pulse_gap_ns >= 1 && timing.direction_setup_ns >= 0);
  assert(timing.band_steps >= 0 && timing.band_steps <= 0.25);
}

void StepGenerator::start(const JointMoment& point) {
  now_ns_ = nanoseconds(point.time_s);
  state_ = {};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    state_[i].position = point.joints.values[i] * axes_[i].steps_per_unit;
    state_[i].count = base::round_away(state_[i].position);
  }
}

base::Result<void> StepGenerator::move_to(const JointMoment& point) {
  const std::int64_t end_ns = nanoseconds(point.time_s);
  assert(end_ns >= now_ns_);
  const auto duration_ns = static_cast<double>(end_ns - now_ns_);
  std::array<double, base::kMaxAxes> targets{};
  std::size_t trains = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    targets[i] = point.joints.values[i] * axes_[i].steps_per_unit;
    if (!(std::abs(targets[i]) <= kMostSteps)) {
      return no_step(at(axes_[i], end_ns) + "position " + base::number_text(targets[i]) +
                     " steps is more than the counter holds");
    }
    const Train train = train_of(i, targets[i], duration_ns);
    if (train.pulses == 0) continue;
    if (auto good = check(i, train); !good) return good;
    trains_[trains++] = train;
  }
  emit(trains, duration_ns);
  for (std::size_t i = 0; i < axes_.size(); ++i) state_[i].position = targets[i];
  now_ns_ = end_ns;
  return {};
}

StepGenerator::Train StepGenerator::train_of(std::size_t axis, double target,
                                             double duration_ns) const {
  const AxisState& state = state_[axis];
  const double way = target - state.position;
  const double towards = way < 0 ? -1.0 : 1.0;
  const auto count = static_cast<double>(state.count);
  Train train;
  train.pulses = std::max(0.0, std::ceil((target - count) * towards - reach_));
  if (train.pulses == 0) return train;
  train.first_steps = reach_ - (state.position - count) * towards;
  train.ns_per_step = duration_ns / std::abs(way);
  train.pulse.axis = static_cast<base::Axis>(axis);
  train.pulse.direction = direction_of(way);
  train.pulse.width_ns = static_cast<std::uint32_t>(timing_.pulse_width_ns);
  train.next_ns = time_of(train, duration_ns);
  return train;
}

// Each pulse from the equation of the line. Clamped, because the last bit of a quotient must not
// carry a pulse over a set-point.
std::int64_t StepGenerator::time_of(const Train& train, double duration_ns) const {
  const double since = (train.first_steps + train.index) * train.ns_per_step;
  return now_ns_ + static_cast<std::int64_t>(std::clamp(since, 0.0, duration_ns) + 0.5);
}

// The pulses of a train are evenly spaced: its first two and the one before tell all.
base::Result<void> StepGenerator::check(std::size_t axis, const Train& train) const {
  const StepAxis& setup = axes_[axis];
  const AxisState& state = state_[axis];
  const auto amplifier = static_cast<double>(timing_.pulse_width_ns + timing_.pulse_gap_ns);
  const double least = setup.most_rate_hz > 0 ? std::max(amplifier, 1e9 / setup.most_rate_hz)  //
                                              : amplifier;
  const auto since_last = static_cast<double>(train.next_ns - state.last_rise_ns);
  if (state.has_stepped && state.last_direction != train.pulse.direction) {
    const std::int64_t settle = timing_.pulse_width_ns + timing_.direction_setup_ns;
    if (since_last < std::max(least, static_cast<double>(settle)) - 1) {
      return no_step(at(setup, train.next_ns) + "turns round " + base::number_text(since_last) +
                     " ns after a step (" + rate_text(since_last) + "); pulse and direction need " +
                     base::number_text(std::ceil(std::max(least, static_cast<double>(settle)))) +
                     " ns");
    }
  }
  double interval = state.has_stepped ? since_last : least;
  if (train.pulses > 1) interval = std::min(interval, train.ns_per_step);
  if (interval < least - 1) {
    return no_step(at(setup, train.next_ns) + rate_text(interval) + ", at most " +
                   base::number_text(std::round(1e9 / least)));
  }
  return {};
}

void StepGenerator::emit(std::size_t trains, double duration_ns) {
  while (trains > 0) {
    std::size_t earliest = 0;
    for (std::size_t i = 1; i < trains; ++i) {
      if (trains_[i].next_ns < trains_[earliest].next_ns) earliest = i;
    }
    Train& train = trains_[earliest];
    train.pulse.time_ns = train.next_ns;
    sink_.take(train.pulse);
    AxisState& state = state_[index(train.pulse.axis)];
    state.count += sign(train.pulse.direction);
    train.index += 1;
    if (train.index < train.pulses) {
      train.next_ns = time_of(train, duration_ns);
      continue;
    }
    state.last_rise_ns = train.pulse.time_ns;
    state.last_direction = train.pulse.direction;
    state.has_stepped = true;
    std::move(&train + 1, trains_.data() + trains, &train);  // the others keep their order
    --trains;
  }
}

}  // namespace kerf::drive
