#include "machine/pattern_replay.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "math/math.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;

constexpr double kNanoseconds = 1e9;
constexpr double kSecondsPerMinute = 60;
// Set-points between two questions whether to break off: some milliseconds.
constexpr std::uint64_t kBetweenQuestions = 1 << 14;

AxisVector tidied(AxisVector v) {
  for (double& value : v.values) value = base::tidy(value);
  return v;
}

}  // namespace

void PatternReplay::Fan::take(const drive::Pulse& pulse) {
  ++count;
  for (drive::PulseSink* const sink : sinks) sink->take(pulse);
}

PatternReplay::PatternReplay(const PatternMachine& machine)
    : machine_(machine),
      drive_(machine.definition().drive.arm, pulses_),
      statistics_(machine.definition().axes),
      tip_(tidied(machine.tip_at(drive::ArmCounts{}))) {
  motions_.push_back(&statistics_);
}

double PatternReplay::seconds(std::int64_t ticks) const {
  const auto ns = machine_.definition().drive.arm.clock.nanoseconds(ticks);
  return static_cast<double>(ns) / kNanoseconds;
}

double PatternReplay::time_s() const { return seconds(drive_.now_ticks()); }

base::Result<void> PatternReplay::take(const drive::PatternRecord& record) {
  const std::int64_t begin = drive_.now_ticks();
  if (!points_.empty())
    lines_.begin(machine_.definition().drive.arm.clock.nanoseconds(begin), drive_.counters());
  auto made = std::visit([this](const auto& r) { return make(r); }, record);
  if (!made) return made;
  const bool fast = std::holds_alternative<drive::FastRecord>(record);
  ++(fast ? totals_.fast : totals_.triplets);
  totals_.pulses = pulses_.count;
  arrive(fast, begin);
  if (!points_.empty()) {
    lines_.end();
    sample(seconds(begin), time_s());
  }
  return {};
}

base::Result<void> PatternReplay::make(const drive::FastRecord& record) {
  drive_.fast(record.move());
  return {};
}

base::Result<void> PatternReplay::make(const drive::Triplet& triplet) {
  const drive::SlowMove move = triplet.move();
  return drive_.slow(move, machine_.half_period_ticks(drive_.counters(), move));
}

// What the record has done, as a motion of the tip.
void PatternReplay::arrive(bool fast, std::int64_t begin_ticks) {
  const AxisVector joints = machine_.joints_at(drive_.counters());
  look_at_travel(joints);
  const AxisVector to = tidied(machine_.kinematics().forward(joints));
  const AxisVector way = to - tip_;
  tip_ = to;
  if (way == AxisVector{}) return;
  control::Motion motion;
  motion.line = static_cast<std::uint32_t>(totals_.fast + totals_.triplets);
  if (fast) {
    motion.action = control::Rapid{to, false};
  } else {
    const double mm = math::hypot(way[machine_.x()], way[machine_.y()]);
    const double minutes = seconds(drive_.now_ticks() - begin_ticks) / kSecondsPerMinute;
    const double length = mm > 0 ? mm : std::fabs(way[machine_.c()]);
    motion.action = control::Line{to, {length / minutes, control::FeedMode::per_minute}};
  }
  for (control::MotionSink* const sink : motions_) sink->take(motion);
}

void PatternReplay::look_at_travel(const AxisVector& joints) {
  const auto& driven = machine_.definition().driven;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const double at = joints.values[i];
    const bool beyond = at < driven[i].travel_low || at > driven[i].travel_high;
    if (!beyond || is_beyond_[i]) continue;
    is_beyond_[i] = true;
    beyond_travel_.push_back({driven[i].name + " goes to " + base::number_text(base::tidy(at)) +
                                  ", beyond its travel of " +
                                  base::number_text(driven[i].travel_low) + " to " +
                                  base::number_text(driven[i].travel_high),
                              totals_.fast + totals_.triplets});
  }
}

// The set-points of (begin, end].
void PatternReplay::sample(double begin_s, double end_s) {
  const double period_s = machine_.definition().interpolator.period_s;
  AxisPoint point;
  point.tip.mark.line = static_cast<std::uint32_t>(totals_.fast + totals_.triplets);
  for (;;) {
    const double time_s = base::tidy(static_cast<double>(period_ + 1) * period_s);
    if (time_s > end_s || broken_off_) return;
    ++period_;
    broken_off_ = period_ % kBetweenQuestions == 0 && broken_off_when_ && broken_off_when_();
    if (time_s <= begin_s) continue;
    point.tip.time_s = time_s;
    point.joints = tidied(machine_.joints_at(lines_.at(time_s * kNanoseconds)));
    point.tip.tip = tidied(machine_.kinematics().forward(point.joints));
    for (AxisPointSink* const sink : points_) sink->take(point);
  }
}

void PatternReplay::finish() {
  if (points_.empty() || totals_.fast + totals_.triplets == 0) return;
  lines_.begin(0, drive_.counters());
  lines_.end();
  const double period_s = machine_.definition().interpolator.period_s;
  if (static_cast<double>(period_) * period_s < time_s())
    sample(time_s(), static_cast<double>(period_ + 1) * period_s * (1 + 1e-12));
}

}  // namespace kerf::machine
