#include "machine/run/run_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/arc.hpp"
#include "math/math.hpp"
#include "motion/path_speed.hpp"
#include "motion/plane_axes.hpp"
#include "motion/spindle_speed.hpp"
#include "motion/surface_path.hpp"
#include "motion/thread_speed.hpp"
#include "motion/turning_rapid.hpp"

namespace kerf::machine {
namespace {

using base::TipPoint;
using geometry::Vec2;
using motion::Feed;
using motion::FeedMode;

constexpr std::size_t kMostMessages = 1000;

}  // namespace

RunStatistics::RunStatistics(const motion::AxisSetup& axes)
    : axes_(axes),
      at_(axes.start),
      low_(axes.start),
      high_(axes.start),
      curves_(axes),
      spindles_(axes.standing_rpm),
      speed_rpm_(axes.standing_rpm) {
  for (std::size_t i = 0; i < axes.count(); ++i) {
    rapid_s_per_unit_[i] = 60 / axes.axes[i].rapid_per_min;
    linear_[i] = !axes.axes[i].rotary;
  }
}

void RunStatistics::reach(const motion::MotionExtent& extent) {
  if (motions_ == 0) {
    low_ = extent.low;
    high_ = extent.high;
    return;
  }
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    low_.values[i] = std::min(low_.values[i], extent.low.values[i]);
    high_.values[i] = std::max(high_.values[i], extent.high.values[i]);
  }
}

// Length along the linear axes; of a rotary-only move in degrees.
double RunStatistics::distance(const TipPoint& to, bool& rotary_only) const {
  double linear = 0;
  double rotary = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double d = to.values[i] - at_.values[i];
    (linear_[i] ? linear : rotary) += d * d;
  }
  rotary_only = linear == 0 && rotary > 0;
  return std::sqrt(rotary_only ? rotary : linear);
}

void RunStatistics::rapid(const TipPoint& to) {
  if (axes_.turning_work) return rapid_over_turning_work(to);
  double seconds = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    seconds = std::max(seconds, std::fabs(to.values[i] - at_.values[i]) * rapid_s_per_unit_[i]);
  }
  bool rotary_only = false;
  const double length = distance(to, rotary_only);
  if (!rotary_only) rapid_mm_ += length;
  seconds_ += seconds;
}

void RunStatistics::rapid_over_turning_work(const TipPoint& to) {
  const auto way = motion::TurningRapid::between(axes_, at_, to);
  bool rotary_only = false;
  rapid_mm_ += way ? way->length_mm() : distance(to, rotary_only);
  seconds_ += motion::TurningRapid::seconds(axes_, at_, to);
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

void RunStatistics::arc(const motion::Arc& arc, std::uint32_t line) {
  const auto plane = motion::plane_axes(arc.plane, axes_);
  if (!plane) return;
  const Vec2 from = plane->project(at_);
  const Vec2 to = plane->project(arc.to);
  const Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == motion::Direction::clockwise;
  double rise = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (linear_[i] && !plane->contains(axis))
      rise = math::hypot(rise, arc.to.values[i] - at_.values[i]);
  }
  const double flat = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const double whole = math::hypot(flat, rise);
  cut(whole, flat, arc.feed, line);
}

void RunStatistics::space_arc(const motion::SpaceArc& arc, std::uint32_t line) {
  const motion::SpaceArcPath path(axes_, at_, arc);
  cut(path.circle().length(), path.circle().length(), arc.feed, line);
}

void RunStatistics::surface_move(const motion::SurfaceMove& move, std::uint32_t line) {
  const motion::SurfacePath path(axes_, at_, move, [](const motion::Curve&) {});
  cut(path.length(), path.length(), move.feed, line);
}

// A thread keeps the speed of its begin.
void RunStatistics::thread(const motion::Thread& thread, std::uint32_t line) {
  if (!in_thread_) thread_rpm_ = motion::rpm_at(spindles_.of_feed(), at_);
  in_thread_ = true;
  const motion::ThreadWay way(thread, at_, axes_);
  cut_mm_ += way.length_mm();
  const double turns = way.revolutions();
  if (thread_rpm_ > 0 && std::isfinite(turns)) {
    seconds_ += turns * 60 / thread_rpm_;
  } else if (untimed_line_ == 0) {
    untimed_line_ = line;
  }
}

void RunStatistics::find_speed(const motion::Motion& motion) {
  const motion::Spindle& spindle = spindles_.of_feed();
  if (!spindle.follows_radius() || motion::target_of(motion) == nullptr) return;
  const auto curves = curves_.of(at_, motion);
  if (!curves.empty()) speed_rpm_ = motion::mean_rpm(spindle, curves);
}

void RunStatistics::take(const motion::Motion& motion) {
  using namespace motion;
  in_thread_ = in_thread_ && !ends_thread(motion);
  find_speed(motion);
  if (const auto* const line = std::get_if<Line>(&motion.action)) {
    bool rotary_only = false;
    const double length = distance(line->to, rotary_only);
    reach({line->to, line->to});
    cut(rotary_only ? 0 : length, length, line->feed, motion.block.line);
    at_ = line->to;
    ++motions_;
    return;
  }
  if (const auto* const to = target_of(motion)) {
    reach(motion::extent_of(axes_, at_, motion));
    if (const auto* const a = std::get_if<Arc>(&motion.action)) {
      arc(*a, motion.block.line);
    } else if (const auto* const in_space = std::get_if<SpaceArc>(&motion.action)) {
      space_arc(*in_space, motion.block.line);
    } else if (const auto* const on_surface = std::get_if<SurfaceMove>(&motion.action)) {
      surface_move(*on_surface, motion.block.line);
    } else if (std::holds_alternative<Rapid>(motion.action)) {
      rapid(*to);
    } else if (const auto* const probe = std::get_if<Probe>(&motion.action)) {
      bool rotary_only = false;
      const double length = distance(*to, rotary_only);
      cut(rotary_only ? 0 : length, length, probe->feed, motion.block.line);
    } else if (const auto* const in_turns = std::get_if<Thread>(&motion.action)) {
      thread(*in_turns, motion.block.line);
    }
    at_ = *to;
    ++motions_;
  } else if (const auto* const dwell = std::get_if<Dwell>(&motion.action)) {
    seconds_ += dwell->seconds;
    dwell_seconds_ += dwell->seconds;
  } else if (const auto* const spindle = std::get_if<Spindle>(&motion.action)) {
    spindles_.take(*spindle);
    speed_rpm_ = spindles_.of_feed().known_rpm();
  } else if (const auto* const tool = std::get_if<ToolChange>(&motion.action)) {
    if (std::find(tools_.begin(), tools_.end(), tool->tool) == tools_.end())
      tools_.push_back(tool->tool);
  } else if (const auto* const message = std::get_if<Message>(&motion.action)) {
    if (messages_.size() < kMostMessages) messages_.emplace_back(message->text.view());
  }
}

}  // namespace kerf::machine
