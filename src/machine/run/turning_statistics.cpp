#include "machine/run/turning_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "motion/motion_extent.hpp"
#include "motion/spindle_speed.hpp"
#include "motion/thread_speed.hpp"

namespace kerf::machine {
namespace {

constexpr double kSameEnd_mm = 0.001;
constexpr std::size_t kMostGroups = 10'000;

// The place of a move that is nearest to `centre` along an axis, as a distance.
double nearest_to(double centre, double low, double high) {
  if (low <= centre && centre <= high) return 0;
  return std::min(std::fabs(low - centre), std::fabs(high - centre));
}

}  // namespace

TurningStatistics::TurningStatistics(const motion::AxisSetup& axes)
    : axes_(axes), spindles_(axes.standing_rpm), at_(axes.start) {}

void TurningStatistics::take(const motion::Motion& motion) {
  if (pass_ && motion::ends_thread(motion)) end_pass();
  if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    turn(*spindle);
  } else if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    tool_ = change->tool;
  } else if (motion::target_of(motion) != nullptr) {
    move(motion);
  }
}

void TurningStatistics::turn(const motion::Spindle& spindle) {
  spindles_.take(spindle);
  if (!spindle.turns()) return;
  SpindleUse& use = uses_[index(spindle.name)];
  use.turned = true;
  use.is_clamped |= spindle.is_clamped;
  if (spindle.mode == motion::Spindle::Mode::rpm) {
    use.most_rpm = std::max(use.most_rpm, spindle.speed);
  } else {
    use.css = true;
  }
}

void TurningStatistics::move(const motion::Motion& motion) {
  const motion::Spindle& spindle = spindles_.of_feed();
  if (spindle.turns() && spindle.follows_radius()) follow_surface_speed(spindle, motion);
  if (const auto* const cut = std::get_if<motion::Thread>(&motion.action)) thread(*cut);
  at_ = *motion::target_of(motion);
}

// A rapid has the speed of its end; a thread keeps that of its begin.
void TurningStatistics::follow_surface_speed(const motion::Spindle& spindle,
                                             const motion::Motion& motion) {
  const base::Axis axis = *spindle.radius_axis;
  motion::MotionExtent extent = motion::extent_of(axes_, at_, motion);
  if (std::holds_alternative<motion::Rapid>(motion.action)) {
    extent.low = extent.high = *motion::target_of(motion);
  } else if (std::holds_alternative<motion::Thread>(motion.action)) {
    extent.low = extent.high = at_;
  } else {
    extent.reach(at_);
  }
  base::TipPoint nearest = at_;
  nearest[axis] = spindle.centre + nearest_to(spindle.centre, extent.low[axis], extent.high[axis]);
  SpindleUse& use = uses_[index(spindle.name)];
  use.most_rpm = std::max(use.most_rpm, motion::rpm_at(spindle, nearest));
  const double radius = nearest[axis] - spindle.centre;
  use.is_clamped |= spindle.limit_rpm() > 0 && radius < motion::radius_of_limit(spindle);
}

double TurningStatistics::along(char letter, const base::TipPoint& tip) const {
  const auto axis = axes_.find(letter);
  return axis ? tip[*axis] : 0;
}

void TurningStatistics::thread(const motion::Thread& thread) {
  if (!pass_) pass_ = Pass{thread.lead, 0, along('X', thread.to), thread.depth_mm, tool_};
  pass_->end = along('Z', thread.to);
}

void TurningStatistics::end_pass() {
  count(groups_, *pass_);
  pass_.reset();
}

void TurningStatistics::count(std::vector<Group>& groups, const Pass& pass) {
  const bool goes_on = !groups.empty() && groups.back().first.lead == pass.lead &&
                       groups.back().first.tool == pass.tool &&
                       std::fabs(groups.back().first.end - pass.end) < kSameEnd_mm;
  if (!goes_on) {
    if (groups.size() >= kMostGroups) return;
    groups.push_back({{pass.lead, 0, 0}, pass});
  }
  Group& group = groups.back();
  ++group.use.passes;
  const double way = base::tidy(std::fabs(pass.radius - group.first.radius));
  group.use.depth = std::max({group.use.depth, way, pass.depth});
}

std::vector<TurningStatistics::ThreadUse> TurningStatistics::threads() const {
  std::vector<Group> groups = groups_;
  if (pass_) count(groups, *pass_);
  std::vector<ThreadUse> list;
  for (const Group& group : groups) list.push_back(group.use);
  return list;
}

}  // namespace kerf::machine
