#include "machine/run_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "control/plane_axes.hpp"
#include "geometry/arc.hpp"

namespace kerf::machine {
namespace {

using base::AxisVector;
using control::Feed;
using control::FeedMode;
using geometry::Vec2;
using geometry::Vec3;

constexpr std::size_t kMostMessages = 1000;

}  // namespace

RunStatistics::RunStatistics(const control::AxisSetup& axes)
    : axes_(axes), at_(axes.start), low_(axes.start), high_(axes.start) {
  for (std::size_t i = 0; i < axes.count(); ++i) {
    rapid_s_per_unit_[i] = 60 / axes.axes[i].rapid_per_min;
    linear_[i] = !axes.axes[i].rotary;
  }
}

void RunStatistics::reach(const AxisVector& point) {
  if (motions_ == 0) {
    low_ = high_ = point;
    return;
  }
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    low_.values[i] = std::min(low_.values[i], point.values[i]);
    high_.values[i] = std::max(high_.values[i], point.values[i]);
  }
}

// Length along the linear axes; of a rotary-only move in degrees.
double RunStatistics::distance(const AxisVector& to, bool& rotary_only) const {
  double linear = 0;
  double rotary = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double d = to.values[i] - at_.values[i];
    (linear_[i] ? linear : rotary) += d * d;
  }
  rotary_only = linear == 0 && rotary > 0;
  return std::sqrt(rotary_only ? rotary : linear);
}

void RunStatistics::rapid(const AxisVector& to) {
  double seconds = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    seconds = std::max(seconds, std::fabs(to.values[i] - at_.values[i]) * rapid_s_per_unit_[i]);
  }
  bool rotary_only = false;
  const double length = distance(to, rotary_only);
  if (!rotary_only) rapid_mm_ += length;
  seconds_ += seconds;
}

void RunStatistics::cut(double length, double feed_length, const Feed& feed, std::uint32_t line) {
  cut_mm_ += length;
  if (feed.value <= 0) return;
  switch (feed.mode) {
    case FeedMode::per_minute: seconds_ += feed_length * 60 / feed.value; break;
    case FeedMode::inverse_time: seconds_ += 60 / feed.value; break;
    case FeedMode::per_revolution:
      if (speed_rpm_ > 0) {
        seconds_ += feed_length * 60 / (feed.value * speed_rpm_);
      } else if (untimed_line_ == 0) {
        untimed_line_ = line;
      }
      break;
  }
}

void RunStatistics::arc(const control::Arc& arc, std::uint32_t line) {
  const auto plane = control::plane_axes(arc.plane, axes_);
  if (!plane) return;
  const Vec2 from = plane->project(at_);
  const Vec2 to = plane->project(arc.to);
  const Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == control::Direction::clockwise;
  double rise = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (linear_[i] && !plane->contains(axis))
      rise = std::hypot(rise, arc.to.values[i] - at_.values[i]);
  }
  const double flat = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const double whole = std::hypot(flat, rise);
  reach_arc(arc, base::index(plane->first), base::index(plane->second));
  cut(whole, flat, arc.feed, line);
}

void RunStatistics::space_arc(const control::SpaceArc& arc, std::uint32_t line) {
  const control::SpaceArcPath path(axes_, at_, arc);
  for (const auto& knot : path.knots().subspan(1)) reach(knot.point);
  reach_farthest(path);
  cut(path.circle().length(), path.circle().length(), arc.feed, line);
}

// Where the circle goes farthest along X, Y and Z. The other axes have their extremes at the points
// given.
void RunStatistics::reach_farthest(const control::SpaceArcPath& path) {
  constexpr Vec3 kDirections[] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                  {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  for (const Vec3 direction : kDirections) {
    const double angle = path.circle().farthest_rad(direction);
    if (angle <= 0 || angle >= path.circle().sweep_rad()) continue;
    AxisVector reached = path.at(angle);
    for (std::size_t i = 0; i < axes_.count(); ++i) {
      if (!linear_[i]) reached.values[i] = path.knots().back().point.values[i];
    }
    reach(reached);
  }
}

// The quadrant points that the arc passes.
void RunStatistics::reach_arc(const control::Arc& arc, std::size_t first, std::size_t second) {
  const bool clockwise = arc.direction == control::Direction::clockwise;
  const Vec2 from{at_.values[first], at_.values[second]};
  const Vec2 to{arc.to.values[first], arc.to.values[second]};
  const Vec2 centre{arc.center[0], arc.center[1]};
  const double sweep =
      arc.turns > 0 ? 2 * std::numbers::pi : geometry::sweep_rad(from, to, centre, clockwise);
  const double radius = std::max(geometry::length(from - centre), geometry::length(to - centre));
  constexpr Vec2 kQuadrants[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const Vec2 quadrant : kQuadrants) {
    const Vec2 point = centre + radius * quadrant;
    if (point == from || geometry::sweep_rad(from, point, centre, clockwise) > sweep) continue;
    AxisVector reached = arc.to;
    reached.values[first] = point.u;
    reached.values[second] = point.v;
    reach(reached);
  }
}

void RunStatistics::take(const control::Motion& motion) {
  using namespace control;
  if (const auto* const line = std::get_if<Line>(&motion.action)) {
    bool rotary_only = false;
    const double length = distance(line->to, rotary_only);
    reach(line->to);
    cut(rotary_only ? 0 : length, length, line->feed, motion.line);
    at_ = line->to;
    ++motions_;
    return;
  }
  if (const auto* const to = target_of(motion)) {
    reach(*to);
    if (const auto* const a = std::get_if<Arc>(&motion.action)) {
      ++motions_;
      arc(*a, motion.line);
      --motions_;
    } else if (const auto* const in_space = std::get_if<SpaceArc>(&motion.action)) {
      ++motions_;
      space_arc(*in_space, motion.line);
      --motions_;
    } else if (std::holds_alternative<Rapid>(motion.action)) {
      rapid(*to);
    } else if (const auto* const probe = std::get_if<Probe>(&motion.action)) {
      bool rotary_only = false;
      const double length = distance(*to, rotary_only);
      cut(rotary_only ? 0 : length, length, probe->feed, motion.line);
    } else if (const auto* const thread = std::get_if<Thread>(&motion.action)) {
      bool rotary_only = false;
      const double length = distance(*to, rotary_only);
      cut(length, length, {thread->lead, FeedMode::per_revolution}, motion.line);
    }
    at_ = *to;
    ++motions_;
  } else if (const auto* const dwell = std::get_if<Dwell>(&motion.action)) {
    seconds_ += dwell->seconds;
    dwell_seconds_ += dwell->seconds;
  } else if (const auto* const spindle = std::get_if<Spindle>(&motion.action)) {
    speed_rpm_ = spindle->mode == Spindle::Mode::rpm ? spindle->speed : spindle->max_rpm;
  } else if (const auto* const tool = std::get_if<ToolChange>(&motion.action)) {
    if (std::find(tools_.begin(), tools_.end(), tool->tool) == tools_.end())
      tools_.push_back(tool->tool);
  } else if (const auto* const message = std::get_if<Message>(&motion.action)) {
    if (messages_.size() < kMostMessages) messages_.emplace_back(message->text.view());
  }
}

}  // namespace kerf::machine
