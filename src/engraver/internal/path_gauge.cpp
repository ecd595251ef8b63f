#include "engraver/internal/path_gauge.hpp"

#include <algorithm>
#include <utility>

#include "math/math.hpp"

namespace kerf::engraver {

using base::TipPoint;

void PathGauge::take(const drive::Pulse& pulse) {
  const bool arm = pulse.axis == drive::axis_of(drive::ArmAxis::theta1) ||
                   pulse.axis == drive::axis_of(drive::ArmAxis::theta2);
  if (moved_ && pulse.time_ns != time_ns_) measure();
  counts_.values[index(pulse.axis)] += sign(pulse.direction);
  moved_ |= arm && curve_ != nullptr;
  time_ns_ = pulse.time_ns;
}

PathGauge::Worst PathGauge::take_worst() {
  if (moved_) measure();
  begins_ = true;
  return std::exchange(worst_, {});
}

// The nearest place by Newton's method, from the last one. Any place of the curve bounds the
// distance from above.
void PathGauge::measure() {
  constexpr int kSteps = 3;
  const TipPoint tip = machine_.tip_at(counts_);
  const base::Axis x = machine_.x();
  const base::Axis y = machine_.y();
  for (int i = 0; i < kSteps; ++i) {
    const base::TipJet jet = curve_->jet(s_);
    const double off_x = jet.value[x] - tip[x];
    const double off_y = jet.value[y] - tip[y];
    const double slope = off_x * jet.first[x] + off_y * jet.first[y];
    const double bend = jet.first[x] * jet.first[x] + jet.first[y] * jet.first[y] +
                        off_x * jet.second[x] + off_y * jet.second[y];
    if (!(bend > 0)) break;
    s_ = std::clamp(s_ - slope / bend, 0.0, curve_->length());
  }
  const TipPoint near = curve_->at(s_);
  const double mm = math::hypot(near[x] - tip[x], near[y] - tip[y]);
  moved_ = false;
  if (begins_) places_.clear();
  begins_ = false;
  places_.push_back({tip[x], tip[y]});
  if (mm > worst_.mm) worst_ = {mm, tip[x], tip[y], near[x], near[y]};
}

}  // namespace kerf::engraver
