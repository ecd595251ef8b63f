#include "control/gcode/path/cutter_compensation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "geometry/arc.hpp"
#include "math/math.hpp"

namespace kerf::control {
namespace {

using base::Code;
using geometry::Curve;
using geometry::Vec2;

constexpr double kSmall_mm = 1e-7;   // two points closer than this are one
constexpr double kSmallTurn = 1e-9;  // sine of the angle below which directions are parallel
constexpr int kMostIdleBlocks = 2;   // CRC-1

Vec2 direction_at_start(const PathStep& step) { return geometry::direction_at_start(step.piece); }
Vec2 direction_at_end(const PathStep& step) { return geometry::direction_at_end(step.piece); }

// The left normal of a counterclockwise arc points to its centre.
double offset_radius(const PathStep& step, Vec2 at, double offset) {
  return geometry::length(at - step.piece.centre) + (step.piece.clockwise ? offset : -offset);
}

Curve offset_curve(const PathStep& step, Vec2 at, Vec2 direction, double offset) {
  if (step.piece.is_arc) return {true, step.piece.centre, {}, offset_radius(step, at, offset)};
  return {false, at + offset * geometry::left_of(direction), direction, 0};
}

bool near(Vec2 a, Vec2 b) { return geometry::length(a - b) <= kSmall_mm; }

// Signed angle from a to b, both seen from the centre.
double angle_between(Vec2 a, Vec2 b) {
  return math::atan2(geometry::cross(a, b), geometry::dot(a, b));
}

}  // namespace

base::TipPoint CutterCompensation::tip() const {
  if (!held_) return tip_;
  base::TipPoint result = *motion::target_of(held_->step.motion);
  for (const Beside& item : beside_) {
    if (const base::TipPoint* const to = motion::target_of(item.motion)) result = *to;
  }
  const Vec2 normal = held_->cutter.offset * geometry::left_of(direction_at_end(held_->step));
  plane_.place(result, held_->step.piece.to + normal + held_->cutter.tip);
  return result;
}

void CutterCompensation::begin(const motion::PlaneAxes& plane, const Cutter& cutter) {
  if (mode_ == Mode::off || mode_ == Mode::ending) {
    mode_ = Mode::armed;
    moved_since_begin_ = false;
    idle_blocks_ = 0;
  }
  plane_ = plane;
  cutter_ = cutter;
}

void CutterCompensation::end() {
  if (mode_ == Mode::armed) mode_ = Mode::off;
  if (mode_ != Mode::on) return;
  if (release()) mode_ = Mode::ending;
}

void CutterCompensation::reset() {
  mode_ = Mode::off;
  held_.reset();
  beside_.clear();
}

bool CutterCompensation::move(const PathStep& step) {
  if (step.piece.is_arc &&
      (near(step.piece.from, step.piece.centre) || near(step.piece.to, step.piece.centre))) {
    return alarms_.raise_at(Code::arc_interference, step.place);  // CRC-11
  }
  switch (mode_) {
    case Mode::off: return emit_programmed(step);
    case Mode::ending:
      if (step.piece.is_arc) return alarms_.raise_at(Code::arc_at_start_up, step.place);
      mode_ = Mode::off;
      return emit_programmed(step);
    case Mode::armed: return start(step);
    case Mode::on: break;
  }
  if (step.piece.is_arc && offset_radius(step, step.piece.from, cutter_.offset) < -kSmall_mm) {
    return alarms_.raise_at(Code::interference, step.place,
                            "the arc's radius is smaller than the cutter's");  // CRC-10
  }
  if (!held_) return hold_here(step, false);
  Corner way;
  if (!corner(step, way) || !go_through(way)) return false;
  return hold(step, way.start, false);
}

// CRC-1, CRC-6: the first move.
bool CutterCompensation::start(const PathStep& step) {
  if (step.piece.is_arc) return alarms_.raise_at(Code::arc_at_start_up, step.place);
  mode_ = Mode::on;
  if (settings_.start_up != 'C' || !moved_since_begin_) return hold_here(step, true);
  const Vec2 start = step.piece.from + cutter_.offset * geometry::left_of(direction_at_start(step));
  shift_ = cutter_.tip;
  return emit_to(inner_part(step), start) && hold(step, start, false);
}

bool CutterCompensation::hold(const PathStep& step, Vec2 start, bool start_up) {
  held_ = Held{step, start, cutter_, start_up};
  idle_blocks_ = 0;
  return true;
}

// From where the tool stands.
bool CutterCompensation::hold_here(const PathStep& step, bool start_up) {
  return hold(step, tip_in_plane() - cutter_.tip, start_up);
}

bool CutterCompensation::end_with(const PathStep& step, std::optional<Vec2> wall) {
  if (step.piece.is_arc) return alarms_.raise_at(Code::arc_at_start_up, step.place);
  if (held_) {
    PathStep next = step;
    Corner way;
    const Vec2 d1 = direction_at_end(held_->step);
    const Vec2 at = held_->step.piece.to;
    const double offset = held_->cutter.offset;
    way.end = at + offset * geometry::left_of(d1);  // type A: perpendicular (CRC-12)
    const Vec2 d2 = wall ? geometry::unit(*wall) : direction_at_start(next);
    const double turn = geometry::cross(d1, d2);
    const bool outside = turn * offset < 0;
    if (wall) {
      const auto points =
          geometry::intersect(offset_curve(held_->step, at, d1, offset),
                              {false, at + offset * geometry::left_of(d2), d2, 0}, kSmall_mm);
      if (points.count > 0) way.end = points.points[0];
    } else if (settings_.start_up == 'B' && outside) {
      turn_outside({at, d1, d2, false}, offset, way);
    }
    if (!go_through(way)) return false;
  }
  mode_ = Mode::off;
  return emit_programmed(step);
}

bool CutterCompensation::beside(const motion::Motion& motion) {
  beside_.push_back({motion, alarms_.place()});
  return held_ || emit_beside();
}

bool CutterCompensation::idle_block() {
  moved_since_begin_ = true;
  gave_up_corner_ = false;
  if (!held_ || ++idle_blocks_ <= kMostIdleBlocks) return true;
  gave_up_corner_ = true;
  return release();
}

bool CutterCompensation::release() {
  if (!held_) return true;
  Corner way;
  way.end = held_->step.piece.to +
            held_->cutter.offset * geometry::left_of(direction_at_end(held_->step));
  return go_through(way);
}

bool CutterCompensation::interrupt() {
  if (!release()) return false;
  if (mode_ == Mode::on) mode_ = Mode::armed;
  moved_since_begin_ = false;
  return true;
}

// The held move cannot be made, and nothing behind it: the machine stops before it.
bool CutterCompensation::refuse_held(Code code, const std::string& detail) {
  alarms_.raise_at(code, held_->step.place, detail);
  held_.reset();
  beside_.clear();
  return false;
}

// Emits what is held along a corner, then everything that waited behind it. Behind a move that
// cannot be made there is nothing.
bool CutterCompensation::go_through(const Corner& corner) {
  const PathStep step = held_->step;
  if (corner.arc || corner.via_count > 0) held_->step = inner_part(step);
  const bool good = emit_held(corner.end) && emit_corner(step, corner);
  held_.reset();
  if (!good) beside_.clear();
  return good && emit_beside();
}

bool CutterCompensation::emit_corner(const PathStep& step, const Corner& corner) {
  if (corner.new_cutter) shift_ = cutter_.tip;
  if (corner.arc) return emit_corner_arc(step, step.piece.to, corner);
  for (std::size_t i = 0; i < corner.via_count; ++i) {
    PathStep bevel = i + 1 < corner.via_count ? inner_part(step) : step;
    bevel.piece.is_arc = false;
    if (!emit_to(bevel, corner.via[i])) return false;
  }
  return true;
}

// The way round the point where the held move meets the next one.
bool CutterCompensation::corner(const PathStep& next, Corner& way) {
  if (held_->start_up) return start_up_corner(next, way);
  const Vec2 at = held_->step.piece.to;
  const Vec2 d1 = direction_at_end(held_->step);
  const Vec2 d2 = direction_at_start(next);
  way.end = at + held_->cutter.offset * geometry::left_of(d1);
  way.start = at + cutter_.offset * geometry::left_of(d2);
  if (held_->cutter != cutter_) {  // CRC-13: both end points, joined
    way.via = {way.start};
    way.via_count = 1;
    way.new_cutter = true;
    return true;
  }
  const double turn = geometry::cross(d1, d2);
  const double same_way = geometry::dot(d1, d2);
  if (std::fabs(turn) <= kSmallTurn && same_way > 0) return true;
  const bool inside = turn * cutter_.offset > 0;
  if (inside || same_way >= -kSmallTurn) {
    Vec2 point;
    if (meet(next, point)) {  // CRC-7, CRC-8
      way.end = way.start = point;
      return true;
    }
    if (inside) return refuse_held(Code::no_intersection);
  }
  turn_outside({at, d1, d2, next.piece.is_arc}, cutter_.offset, way);
  return true;
}

// Points round an outside corner: intersection of the tangents up to 90 degrees (CRC-4, CRC-8), the
// bevel or arc beyond (CRC-5, CRC-9). Arcs are left and reached where their circles end (CRC-10).
void CutterCompensation::turn_outside(const Turn& turn, double offset, Corner& way) const {
  const Vec2 n1 = geometry::left_of(turn.before);
  const Vec2 n2 = geometry::left_of(turn.behind);
  way.end = turn.at + offset * n1;
  way.start = turn.at + offset * n2;
  if (geometry::dot(turn.before, turn.behind) >= -kSmallTurn) {
    way.add(turn.at + (offset / (1 + geometry::dot(n1, n2))) * (n1 + n2));
  } else if (settings_.corner_arc) {
    way.arc = true;
    way.clockwise = offset > 0;
    return;
  } else {
    const double reach = std::fabs(offset);
    way.add(way.end + reach * turn.before);
    way.add(way.start - reach * turn.behind);
  }
  if (turn.into_arc) {
    way.add(way.start);
  } else {
    way.start = way.via[way.via_count - 1];
  }
  if (!held_->step.piece.is_arc) way.begin_at_first();
}

// CRC-2, CRC-3, CRC-4, CRC-5: the end of the start-up move.
bool CutterCompensation::start_up_corner(const PathStep& next, Corner& way) {
  held_->cutter = cutter_;
  const Vec2 at = held_->step.piece.to;
  const Vec2 d1 = direction_at_end(held_->step);
  const Vec2 d2 = direction_at_start(next);
  const bool outside = geometry::cross(d1, d2) * cutter_.offset < 0;
  way.end = way.start = at + cutter_.offset * geometry::left_of(d2);
  if (settings_.start_up == 'B' && outside)
    turn_outside({at, d1, d2, next.piece.is_arc}, cutter_.offset, way);
  return true;
}

// The common point of the offsets of the held move and the next one that lies nearest to the
// corner.
bool CutterCompensation::meet(const PathStep& next, Vec2& point) const {
  const Vec2 at = held_->step.piece.to;
  const Curve a =
      offset_curve(held_->step, at, direction_at_end(held_->step), held_->cutter.offset);
  const Curve b = offset_curve(next, next.piece.from, direction_at_start(next), cutter_.offset);
  const geometry::Intersections found = geometry::intersect(a, b, kSmall_mm);
  if (found.count == 0) return false;
  point = found.points[0];
  if (found.count == 2 && geometry::length(found.points[1] - at) < geometry::length(point - at)) {
    point = found.points[1];
  }
  return true;
}

// Angle that the compensated arc sweeps in its direction, radians: that of the programmed one,
// changed by what its ends have moved. Negative when it would run backwards.
double CutterCompensation::compensated_sweep(Vec2 end) const {
  const geometry::Piece& arc = held_->step.piece;
  const double sign = arc.clockwise ? -1 : 1;
  const auto moved = [&](Vec2 from, Vec2 to) {
    return sign * angle_between(from - arc.centre, to - arc.centre);
  };
  return geometry::sweep_rad(arc.from, arc.to, arc.centre, arc.clockwise) + moved(arc.to, end) -
         moved(arc.from, held_->start);
}

// CRC-14: the compensated move must not run against the programmed one.
bool CutterCompensation::runs_backwards(Vec2 end) const {
  const geometry::Piece& piece = held_->step.piece;
  if (held_->start_up) return false;
  if (!piece.is_arc) {
    const Vec2 programmed = piece.to - piece.from;
    return geometry::dot(end - held_->start, programmed) <
           -kSmall_mm * geometry::length(programmed);
  }
  if (near(held_->start, piece.centre) || near(end, piece.centre)) return false;
  return compensated_sweep(end) < -kSmallTurn;
}

bool CutterCompensation::emit_held(Vec2 end) {
  const PathStep& step = held_->step;
  shift_ = held_->cutter.tip;
  if (runs_backwards(end)) {
    return refuse_held(Code::interference, "the compensated move would run backwards");
  }
  // An arc that ends where it begins is a full circle to whoever reads it: rounding must not make
  // one of an arc that has shrunk to nothing, nor nothing of a circle.
  if (step.piece.is_arc && near(end, centre())) {
    if (compensated_sweep(end) < std::numbers::pi) return true;
    end = centre();
  }
  return emit_to(step, end);
}

// Without compensation: what was programmed.
bool CutterCompensation::emit_programmed(const PathStep& step) {
  shift_ = {};
  return emit_to(step, step.piece.to);
}

Vec2 CutterCompensation::shifted(Vec2 of_centre) const {
  if (shift_ == Vec2{}) return of_centre;
  const Vec2 at = of_centre + shift_;
  return {base::tidy(at.u), base::tidy(at.v)};
}

Vec2 CutterCompensation::emitted(Vec2 of_centre) const {
  const Vec2 at = shifted(of_centre);
  return {base::tidy(at.u), base::tidy(at.v)};
}

bool CutterCompensation::emit_to(const PathStep& step, Vec2 to) {
  motion::Motion motion = step.motion;
  const auto place = [&](auto& action) {
    if constexpr (requires { action.to; }) plane_.place(action.to, emitted(to));
    if constexpr (requires { action.center; }) {
      const Vec2 about = shifted({action.center[0], action.center[1]});
      action.center = {about.u, about.v};
    }
  };
  if (step.piece.is_arc && near(centre(), step.piece.centre)) return true;  // R' = 0
  if (!step.piece.is_arc && std::holds_alternative<motion::Arc>(motion.action)) {
    const motion::Arc& arc = std::get<motion::Arc>(step.motion.action);
    motion.action = motion::Line{arc.to, arc.feed};
  }
  std::visit(place, motion.action);
  return emit(motion, step.place);
}

bool CutterCompensation::emit_corner_arc(const PathStep& step, Vec2 about, const Corner& corner) {
  motion::Motion motion = step.motion;
  motion::Feed feed;
  base::TipPoint to = *motion::target_of(motion);
  std::visit(
      [&](const auto& action) {
        if constexpr (requires { action.feed; }) feed = action.feed;
      },
      motion.action);
  plane_.place(to, emitted(corner.start));
  const Vec2 arc_centre = shifted(about);
  if (auto* const rapid = std::get_if<motion::Rapid>(&motion.action)) {
    rapid->to = to;
  } else {
    const motion::Plane plane = plane_.first_offset == 'I'   ? motion::Plane::xy
                                : plane_.first_offset == 'K' ? motion::Plane::zx
                                                             : motion::Plane::yz;
    motion.action = motion::Arc{
        to,
        {arc_centre.u, arc_centre.v},
        feed,
        0,
        plane,
        corner.clockwise ? motion::Direction::clockwise : motion::Direction::counterclockwise};
  }
  return emit(motion, step.place);
}

bool CutterCompensation::emit(const motion::Motion& motion, const base::Place& place) {
  base::TipPoint target = tip_;
  if (const base::TipPoint* const to = motion::target_of(motion)) target = *to;
  const bool moves = motion::target_of(motion) != nullptr;
  const bool closed_arc = std::holds_alternative<motion::Arc>(motion.action);
  const bool probe = std::holds_alternative<motion::Probe>(motion.action);
  if (moves && target == tip_ && !closed_arc && !probe) return true;  // goes nowhere
  if (!outlet_.let_out(motion, tip_, &place)) return false;
  tip_ = target;
  return true;
}

bool CutterCompensation::emit_beside() {
  const auto stay = [this](auto& action) {
    if constexpr (requires { action.to; }) plane_.place(action.to, tip_in_plane());
  };
  const bool good = std::all_of(beside_.begin(), beside_.end(), [&](Beside& item) {
    std::visit(stay, item.motion.action);
    return emit(item.motion, item.place);
  });
  beside_.clear();
  return good;
}

}  // namespace kerf::control
