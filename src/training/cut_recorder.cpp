#include "training/cut_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::training {
namespace {

using geometry::Vec3;

// Nearer to the top of the work than this is on it.
constexpr double kTouch_mm = 1e-6;

bool is_rapid(const motion::Motion& motion) {
  return std::holds_alternative<motion::Rapid>(motion.action);
}

}  // namespace

CutRecorder::CutRecorder(const machine::MachineDefinition& machine, const Work& work,
                         double most_mm, std::function<void()> full)
    : work_(work),
      most_mm_(most_mm),
      full_(std::move(full)),
      curves_(machine.axes),
      at_(machine.axes.start) {
  constexpr std::array<char, 3> kLetters = {'X', 'Y', 'Z'};
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    linear_[i] = base::index(machine.axes.find(kLetters[i]).value_or(base::Axis{0}));
  for (std::size_t m = 0; m < machine.axes.count() && rotary_.size() < with_.rotary_deg.size(); ++m)
    if (machine.axes.axes[m].rotary) rotary_.push_back(m);
}

Vec3 CutRecorder::in_work(const base::TipPoint& at) const {
  const Vec3 place =
      Vec3{at.values[linear_[0]], at.values[linear_[1]], at.values[linear_[2]]} - work_.zero;
  if (work_.process != Process::turning) return place;
  return {place.z, 0, std::fabs(place.x) - work_.bar_radius};
}

bool CutRecorder::cuts(Vec3 from, Vec3 to) const {
  if (from == to) return false;  // rotary axes alone
  if (work_.process == Process::beam) return with_.power_percent > 0;
  if (work_.process == Process::turning && std::min(from.x, to.x) >= -kTouch_mm) return false;
  return std::min(from.z, to.z) < -kTouch_mm;
}

void CutRecorder::take(const motion::Motion& motion) {
  if (is_full()) return;
  if (motion::target_of(motion) != nullptr) {
    move(motion);
  } else if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    with_.tool = change->tool;
  } else if (const auto* const power = std::get_if<motion::Power>(&motion.action)) {
    with_.power_percent = power->beam_percent();
  } else if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    with_.spindle_turns = spindle->speed > 0 && spindle->turns();
  }
}

void CutRecorder::move(const motion::Motion& motion) {
  const base::TipPoint end = *motion::target_of(motion);
  base::TipPoint from = at_;
  if (is_rapid(motion)) {
    strokes_.push_back(
        {in_work(at_), in_work(end), motion.block.file, motion.block.line, cuts_.size()});
  } else {
    for (const motion::Curve& curve : curves_.of(at_, motion)) {
      feed_along(curve, from, motion);
      from = curve.end();
    }
  }
  at_ = end;
}

void CutRecorder::feed_along(const motion::Curve& curve, const base::TipPoint& begin,
                             const motion::Motion& motion) {
  fed_mm_ += curve.length();
  if (is_full()) return full_();
  const double pieces = std::max(1.0, std::ceil(curve.length() / kPiece_mm));
  Vec3 from = in_work(begin);
  for (double i = 1; i <= pieces; ++i) {
    const base::TipPoint at = curve.at(curve.length() * (i / pieces));
    const Vec3 to = in_work(at);
    if (cuts(from, to)) {
      for (std::size_t r = 0; r < rotary_.size(); ++r) with_.rotary_deg[r] = at.values[rotary_[r]];
      cuts_.push_back({from, to, with_, motion.block.file, motion.block.line});
      length_mm_ += cuts_.back().length();
    }
    from = to;
  }
}

}  // namespace kerf::training
