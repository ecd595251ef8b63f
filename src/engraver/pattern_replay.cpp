#include "engraver/pattern_replay.hpp"

#include "base/decimal.hpp"

namespace kerf::engraver {
namespace {

constexpr double kNanoseconds = 1e9;
// Set-points between two questions whether to break off: some milliseconds.
constexpr std::uint64_t kBetweenQuestions = 1 << 14;

}  // namespace

void PatternReplay::Fan::take(const drive::Pulse& pulse) {
  ++count;
  for (drive::PulseSink* const sink : sinks) sink->take(pulse);
}

PatternReplay::PatternReplay(const machine::PatternMachine& machine)
    : machine_(machine), motors_(machine, pulses_), statistics_(machine.definition().axes) {
  motions_.push_back(&statistics_);
}

template <typename Make>
base::Result<void> PatternReplay::follow(std::uint64_t& count, const Make& make) {
  const double begin_s = time_s();
  if (!points_.empty()) lines_.begin(motors_.time_ns(), motors_.counters());
  if (auto made = make(); !made) return made;
  ++count;
  totals_.pulses = pulses_.count;
  look_at_travel();
  tell_motion();
  if (!points_.empty()) {
    lines_.end();
    sample(begin_s, time_s());
  }
  return {};
}

base::Result<void> PatternReplay::take(const drive::PatternRecord& record) {
  const bool is_fast = std::holds_alternative<drive::FastRecord>(record);
  return follow(is_fast ? totals_.fast : totals_.triplets, [&] { return motors_.make(record); });
}

base::Result<void> PatternReplay::take(const drive::ListedLinked& linked) {
  return follow(totals_.linked, [&] { return motors_.make_linked(linked.counts); });
}

void PatternReplay::tell_motion() {
  if (!motors_.motion()) return;
  motion::Motion motion = *motors_.motion();
  motion.block.line = static_cast<std::uint32_t>(records());
  for (motion::MotionSink* const sink : motions_) sink->take(motion);
}

void PatternReplay::look_at_travel() {
  for (std::size_t joint = 0; joint < drive::kArmAxes; ++joint) {
    if (is_beyond_[joint] || !motors_.is_beyond_travel(joint)) continue;
    is_beyond_[joint] = true;
    beyond_travel_.push_back({motors_.words_beyond_travel(joint), records()});
  }
}

// The set-points of (begin, end].
void PatternReplay::sample(double begin_s, double end_s) {
  const double period_s = machine_.definition().interpolator.period_s;
  motion::AxisPoint point;
  point.tip.mark.block.line = static_cast<std::uint32_t>(records());
  for (;;) {
    const double time_s = base::tidy(static_cast<double>(period_ + 1) * period_s);
    if (time_s > end_s || broken_off_) return;
    ++period_;
    broken_off_ = period_ % kBetweenQuestions == 0 && broken_off_when_ && broken_off_when_();
    if (time_s <= begin_s) continue;
    point.tip.time_s = time_s;
    const machine::PatternStand stand =
        machine::stand_after(machine_, lines_.at(time_s * kNanoseconds));
    point.joints = stand.joints;
    point.tip.tip = stand.tip;
    for (motion::AxisPointSink* const sink : points_) sink->take(point);
  }
}

void PatternReplay::finish() {
  if (points_.empty() || records() == 0) return;
  lines_.begin(0, motors_.counters());
  lines_.end();
  const double period_s = machine_.definition().interpolator.period_s;
  if (static_cast<double>(period_) * period_s < time_s())
    sample(time_s(), static_cast<double>(period_ + 1) * period_s * (1 + 1e-12));
}

}  // namespace kerf::engraver
