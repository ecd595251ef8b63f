#include "motion/thread_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/axis_norms.hpp"

namespace kerf::motion {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

ThreadWay::ThreadWay(const Thread& thread, const base::TipPoint& from, const AxisSetup& axes)
    : lead_(std::fabs(thread.lead)), lead_change_(thread.lead_change) {
  const base::AxisVector way = thread.to - from;
  length_mm_ = AxisNorms{linear_axes(axes), axes.count()}.mm(way);
  for (std::size_t m = 0; m < axes.count(); ++m) {
    if (!axes.axes[m].rotary) lead_way_mm_ = std::max(lead_way_mm_, std::fabs(way.values[m]));
  }
}

double ThreadWay::lead_square_at(double way_mm) const {
  return lead_ * lead_ + 2 * lead_change_ * way_mm;
}

// z = L θ + K θ²/2, in the form without a quotient by K.
double ThreadWay::revolutions() const {
  const double square = lead_square_at(lead_way_mm_);
  if (lead_way_mm_ == 0) return 0;
  if (square < 0 || lead_ == 0) return kInfinite;
  return 2 * lead_way_mm_ / (lead_ + std::sqrt(square));
}

PathSpeed ThreadWay::speed(double rpm) const {
  if (!(rpm > 0) || lead_ == 0 || lead_way_mm_ == 0) return PathSpeed::constant(kInfinite);
  const double turns_s = rpm / 60;
  const double ratio = length_mm_ / lead_way_mm_;
  const double speed = lead_ * turns_s * ratio;
  if (lead_change_ == 0) return PathSpeed::constant(speed);
  return PathSpeed::growing(speed, turns_s * turns_s * lead_change_ * ratio);
}

double ThreadWay::largest_lead_mm() const {
  return std::sqrt(std::max(lead_ * lead_, lead_square_at(lead_way_mm_)));
}

double highest_rpm(const Thread& thread, const base::TipPoint& from, const AxisSetup& axes) {
  const ThreadWay way(thread, from, axes);
  double most = kInfinite;
  for (std::size_t m = 0; m < axes.count(); ++m) {
    const double share = std::fabs(thread.to.values[m] - from.values[m]);
    const double per_turn = share * way.largest_lead_mm() / way.lead_way_mm();
    if (share > 0 && way.lead_way_mm() > 0)
      most = std::min(most, axes.axes[m].rapid_per_min / per_turn);
  }
  return most;
}

}  // namespace kerf::motion
