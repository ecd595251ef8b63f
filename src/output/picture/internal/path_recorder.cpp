#include "output/picture/internal/path_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "geometry/space_arc.hpp"
#include "motion/surface_path.hpp"
#include "motion/turning_rapid.hpp"

namespace kerf::output::plot {
namespace {

// Chords of arcs in space leave them by 0.03 % of the radius, as the curves of the others do.
constexpr double kChord_rad = 2 * std::numbers::pi / 128;

constexpr double kLargest = PathStore::kLargestCoordinate;

geometry::Vec3 vector(const Point3& point) { return {point[kX], point[kY], point[kZ]}; }
Point3 point(geometry::Vec3 vector) { return {vector.x, vector.y, vector.z}; }

// The coordinates of a plane's axes, in the plane's order.
std::array<std::size_t, 2> plane_axes(motion::Plane plane) {
  switch (plane) {
    case motion::Plane::xy: return {kX, kY};
    case motion::Plane::zx: return {kZ, kX};
    case motion::Plane::yz: return {kY, kZ};
  }
  return {kX, kY};
}

}  // namespace

PathRecorder::PathRecorder(const motion::AxisSetup& axes)
    : axes_(axes),
      turns_(axes.turns()),
      tip_(axes.start),
      space_(axes),
      position_(space_.point_of(axes.start, {})) {
  travels_.add(position_);
}

void PathRecorder::take(const motion::Motion& motion) {
  std::visit(
      [this](const auto& action) {
        using Action = std::decay_t<decltype(action)>;
        if constexpr (std::is_same_v<Action, motion::Rapid>) {
          rapid(action);
        } else if constexpr (std::is_same_v<Action, motion::Probe>) {
          straight(action.to, Trace::travel);
        } else if constexpr (std::is_same_v<Action, motion::Arc>) {
          arc(action);
        } else if constexpr (std::is_same_v<Action, motion::SpaceArc>) {
          space_arc(action);
        } else if constexpr (std::is_same_v<Action, motion::SurfaceMove>) {
          surface_move(action);
        } else if constexpr (std::is_same_v<Action, motion::Thread>) {
          thread(action);
        } else if constexpr (std::is_same_v<Action, motion::ToolChange>) {
          select_tool(action.tool);
        } else if constexpr (std::is_same_v<Action, motion::Power>) {
          beam_off_ = !(action.beam_percent() > 0);
        } else if constexpr (requires { action.to; }) {
          straight(action.to, at_feed());
        }
      },
      motion.action);
  if (const base::TipPoint* const to = motion::target_of(motion)) tip_ = *to;
}

void PathRecorder::rapid(const motion::Rapid& rapid) {
  if (axes_.turning_work) {
    if (const auto way = motion::TurningRapid::between(axes_, tip_, rapid.to)) {
      constexpr double kChords = 64;
      const motion::Curve curve = way->curve();
      for (double n = 1; n < kChords; ++n) travel_through(curve.at(curve.length() * n / kChords));
    }
  }
  straight(rapid.to, Trace::travel);
}

void PathRecorder::travel_through(const base::TipPoint& place) { go(place, Trace::travel); }

void PathRecorder::straight(const base::TipPoint& target, Trace trace) {
  ++moves_;
  go(target, trace);
}

void PathRecorder::go(const base::TipPoint& target, Trace trace) {
  const Point3 to = point_of(target);
  if (to == position_) return;
  const Pen pen = pen_for(trace);
  if (has_y()) holes_.move(position_, to, pen);
  store_.line(pen, position_, to);
  arrive(to, trace);
}

void PathRecorder::arc(const motion::Arc& arc) {
  if (!can_bend(arc)) return straight(arc.to, at_feed());
  ++moves_;
  const ArcPath path(position_, arc, point_of(arc.to), arc.center);
  const Trace trace = at_feed();
  const Pen pen = pen_for(trace);
  if (trace == Trace::cut) holes_.sideways_cut();
  store_.arc(pen, path);
  path.extend(trace == Trace::cut ? cuts_ : travels_);
  arrive(path.to(), trace);
}

// Points that carry no arc, because the machine lacks an axis, are joined by lines.
void PathRecorder::space_arc(const motion::SpaceArc& arc) {
  using geometry::SpaceArc;
  const auto at = [this](const base::TipPoint& tip) { return vector(point_of(tip)); };
  const geometry::Vec3 from = vector(position_);
  const auto found = arc.full_circle ? SpaceArc::circle(from, at(arc.via), at(arc.second_via))
                                     : SpaceArc::through(from, at(arc.via), at(arc.to));
  ++moves_;
  if (!found) {
    chord(point_of(arc.via));
    if (arc.full_circle) chord(point_of(arc.second_via));
    return chord(point_of(arc.to));
  }
  const double count = std::ceil(found->sweep_rad() / kChord_rad);
  for (double n = 1; n <= count; ++n) chord(point(found->at(found->sweep_rad() * n / count)));
}

void PathRecorder::surface_move(const motion::SurfaceMove& move) {
  constexpr double kChords = 8;  // of each curve, which is short
  ++moves_;
  const motion::SurfacePath path(axes_, tip_, move, [this](const motion::Curve& curve) {
    for (double n = 1; n <= kChords; ++n) chord(point_of(curve.at(curve.length() * n / kChords)));
  });
}

// A part of a move at feed that goes sideways.
void PathRecorder::chord(const Point3& to) {
  if (to == position_) return;
  const Trace trace = at_feed();
  const Pen pen = pen_for(trace);
  if (trace == Trace::cut) holes_.sideways_cut();
  store_.line(pen, position_, to);
  arrive(to, trace);
}

void PathRecorder::thread(const motion::Thread& thread) {
  const std::uint32_t number = tools_[tool_].number;
  if (turns()) select_tool(number, true);
  straight(thread.to, at_feed());
  if (turns()) select_tool(number);
}

void PathRecorder::select_tool(std::uint32_t number, bool thread) {
  const auto is_it = [&](const Tool& tool) {
    return tool.number == number && tool.thread == thread;
  };
  const auto i = static_cast<std::size_t>(std::ranges::find_if(tools_, is_it) - tools_.begin());
  if (i == tools_.size() && i < kMaxTools) tools_.push_back({number, thread, false, {}});
  tool_ = static_cast<std::uint16_t>(std::min(i, kMaxTools - 1));
}

Pen PathRecorder::pen_for(Trace trace) {
  if (trace == Trace::travel) return {Trace::travel, 0};
  Tool& tool = tools_[tool_];
  if (cuts_.empty()) first_cut_ = position_;
  if (!tool.cuts) {
    tool.cuts = true;
    tool.first_cut = position_;
  }
  return {Trace::cut, tool_};
}

void PathRecorder::arrive(const Point3& to, Trace trace) {
  if (trace == Trace::travel) {
    travels_.add(to);
  } else {
    if (last_ == Trace::travel) cuts_.add(position_);
    cuts_.add(to);
    last_cut_ = to;
  }
  position_ = to;
  last_ = trace;
}

Box3 PathRecorder::all_extents() const {
  Box3 all = travels_;
  if (cuts_.empty()) return all;
  all.add(cuts_.low());
  all.add(cuts_.high());
  return all;
}

// An arc whose plane the machine lacks, or whose centre is nowhere, is drawn as its chord.
bool PathRecorder::can_bend(const motion::Arc& arc) const {
  const auto axes = plane_axes(arc.plane);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!space_.has(axes[i]) || !(std::abs(arc.center[i]) <= kLargest)) return false;
  }
  return true;
}

}  // namespace kerf::output::plot
