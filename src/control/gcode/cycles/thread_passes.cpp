#include "control/gcode/cycles/thread_passes.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"

namespace kerf::control {
namespace {

using geometry::Vec2;

constexpr double kSame = 1e-9;  // depths that differ by less are one

double slope_of_flank(double tip_angle_deg) {
  const geometry::SineCosine half = geometry::sine_cosine_deg(tip_angle_deg / 2);
  return half.sine / half.cosine;
}

}  // namespace

ThreadDepths::ThreadDepths(const ThreadPlan& plan)
    : first_(plan.first_depth),
      least_(plan.least_depth),
      rough_(std::max(plan.height - plan.finish, 0.0)),
      height_(plan.height),
      finish_left_(plan.finish_passes) {}

bool ThreadDepths::next(double& depth) {
  if (depth_ < rough_ - kSame) {
    ++count_;
    const double wanted = first_ * std::sqrt(count_);
    depth = depth_ = std::min(std::max(wanted, depth_ + least_), rough_);
    return true;
  }
  depth = depth_ = height_;
  rough_ = 0;
  return finish_left_-- > 0;
}

ThreadPasses::ThreadPasses(const ThreadPlan& plan)
    : plan_(plan), depths_(plan), slope_(slope_of_flank(plan.tip_angle_deg)) {}

// Outside or inside is where the start of the thread lies seen from the tool.
bool ThreadPasses::advance() {
  double depth = 0;
  if (!depths_.next(depth)) return false;
  const double bottom_at_start = plan_.end.v + plan_.taper;
  const double out = bottom_at_start <= plan_.home.v ? 1 : -1;
  const double left = out * (plan_.height - depth);
  const double along = std::copysign(depth * slope_, plan_.end.u - plan_.home.u);
  const Vec2 from{base::tidy(plan_.home.u + along), base::tidy(bottom_at_start + left)};
  const Vec2 to{plan_.end.u, base::tidy(plan_.end.v + left)};
  for (const TurningMove& move : thread_cut(plan_.home, from, to, plan_.run_out)) add(move);
  count_pass();
  return true;
}

}  // namespace kerf::control
