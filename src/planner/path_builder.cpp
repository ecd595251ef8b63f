#include "planner/path_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/angle.hpp"
#include "motion/feed.hpp"
#include "motion/spindle_speed.hpp"
#include "motion/thread_speed.hpp"

namespace kerf::planner {
namespace {

using base::TipPoint;
using motion::Motion;
using motion::PathSpeed;

// Shares of the tolerance: what a smoothed chain may take, and what a corner beside one cannot.
constexpr double kChainShare = 0.25;
// Length per second: slower than any control moves. It keeps times finite.
constexpr double kSlowest = 1e-9;
// A corner takes less than half of a curve, so that something is left between two of them.
constexpr double kMostOfCurve = 0.49;
// Of what set-points may be away from the way on a surface, at a corner there.
constexpr double kSurfaceShare = 0.5;
// What one motion may add: a chain's worth of curves with their roundings.
constexpr std::size_t kPiecesOfMotion = 600;
constexpr std::size_t kMarksOfMotion = 600;

}  // namespace

PathBuilder::PathBuilder(const motion::AxisSetup& axes, const CellLimits& limits,
                         const Settings& settings, Path& path, const Linkage* linkage)
    : axes_(axes),
      norms_{motion::linear_axes(axes), axes.count()},
      tolerance_mm_(settings.tolerance_mm),
      curve_tolerance_mm_(settings.tolerance_mm),
      surface_tolerance_mm_(
          std::min(settings.tolerance_mm, kSurfaceShare * settings.chord_tolerance_mm)),
      follower_(linkage),
      corners_(limits, axes.count(), norms_.linear, follower_),
      chain_(kChainShare * settings.tolerance_mm, axes.count(), norms_.linear, follower_),
      curves_(axes),
      path_(path),
      at_(axes.start),
      keeps_spindle_angle_(settings.sampling == Sampling::planned),
      spindles_(axes) {}

bool PathBuilder::room() const {
  return path_.pieces.room() >= kPiecesOfMotion && path_.marks.room() >= kMarksOfMotion;
}

// Length of the path per second or turn. A feed that cannot be told is no limit.
Pace PathBuilder::pace_of(const Motion& motion, const motion::Feed& feed, double length) const {
  const bool turned = feed.mode == motion::FeedMode::per_revolution;
  if (turned && spindles_.of_feed().follows_radius() && feed.value > 0)
    return {std::max(feed.value * spindles_.override_factor(), kSlowest), true,
            motion.fixed_override};
  const double speed = motion::feed_per_minute(feed, length, spindles_.of_feed().known_rpm()) *
                       (turned ? spindles_.override_factor() : 1) / 60;
  return {speed > 0 ? std::max(speed, kSlowest) : kInfinite, false, motion.fixed_override};
}

PathBuilder::Drive PathBuilder::drive_at(const Pace& pace) const {
  return {pace.per_turn ? PathSpeed::surface(spindles_.of_feed(), pace.value)
                        : PathSpeed::constant(pace.value),
          pace.fixed_override};
}

double PathBuilder::speed_at(const Pace& pace, const TipPoint& tip) const {
  return pace.per_turn ? pace.value * motion::rpm_at(spindles_.of_feed(), tip) / 60 : pace.value;
}

motion::Mark PathBuilder::mark_of(const Motion& motion, motion::MoveKind kind, double speed) const {
  return {motion.block,
          kind,
          static_cast<float>(power_.beam_percent()),
          power_.follows_speed,
          power_.frequency_hz,
          std::isfinite(speed) ? static_cast<float>(speed) : 0,
          tool_,
          motions_};
}

void PathBuilder::take(const Motion& motion) {
  using namespace motion;
  ++motions_;
  if (motion::is_cut(motion) || std::holds_alternative<Probe>(motion.action))
    await_spindles(motion);
  if (in_thread_ && motion::ends_thread(motion)) end_thread();
  if (const auto* const line = std::get_if<Line>(&motion.action)) {
    add_line(motion, line->to, line->feed);
  } else if (const auto* const arc = std::get_if<Arc>(&motion.action)) {
    add_arc(motion, arc->to, arc->feed);
  } else if (const auto* const space_arc = std::get_if<SpaceArc>(&motion.action)) {
    add_arc(motion, space_arc->to, space_arc->feed);
  } else if (const auto* const surface_move = std::get_if<SurfaceMove>(&motion.action)) {
    add_surface_move(motion, *surface_move);
  } else if (const auto* const rapid = std::get_if<Rapid>(&motion.action)) {
    add_rapid(motion, *rapid);
  } else if (const auto* const probe = std::get_if<Probe>(&motion.action)) {
    stop();
    add_line(motion, probe->to, probe->feed);
  } else if (const auto* const thread = std::get_if<Thread>(&motion.action)) {
    return add_thread(motion, *thread);
  } else if (const auto* const dwell = std::get_if<Dwell>(&motion.action)) {
    add_dwell(motion, dwell->seconds);
  } else if (const auto* const power = std::get_if<Power>(&motion.action)) {
    power_ = *power;
  } else if (const auto* const spindle = std::get_if<Spindle>(&motion.action)) {
    stop();
    note(spindles_.command(*spindle, at_));
  } else if (const auto* const change = std::get_if<ToolChange>(&motion.action)) {
    stop();
    tool_ = change->tool;
  } else if (!std::holds_alternative<Message>(motion.action)) {
    stop();
  }
  if (motion::is_cut_at_feed(motion)) spindles_.cut_to(at_);
  if (motion.exact_stop) stop();
}

void PathBuilder::add_line(const Motion& motion, const TipPoint& to, const motion::Feed& feed) {
  const double linear = norms_.mm(to - at_);
  const bool rotary_only = linear == 0;
  const double length = rotary_only ? norms_.degrees(to - at_) : linear;
  if (length == 0) return;
  if (rotary_only != rotary_only_) stop();
  rotary_only_ = rotary_only;
  if (!chain_.empty() && !chain_.accepts(to, length)) drain_chain(true);
  if (chain_.empty()) chain_.start(at_);
  const Pace pace = pace_of(motion, feed, length);
  chain_.add(to, length, pace, mark_of(motion, motion::MoveKind::cut, speed_at(pace, to)));
  at_ = to;
  drain_chain(tolerance_mm_ == 0);
}

// Where one leg of it meets the next only the slowing down of an axis that is done shapes the way.
void PathBuilder::add_rapid(const Motion& motion, const motion::Rapid& rapid) {
  stop();
  if (const auto turn = spindles_.go_fast_to(rapid.to)) note(*turn);
  rapid_ = true;
  add_curves(curves_.of(at_, motion), mark_of(motion, motion::MoveKind::rapid),
             {PathSpeed::constant(kInfinite)});
  at_ = rapid.to;
  stop();
  rapid_ = false;
}

void PathBuilder::add_arc(const Motion& motion, const TipPoint& to, const motion::Feed& feed) {
  const auto curves = curves_.of(at_, motion);
  if (curves.empty()) return;
  if (rotary_only_) stop();
  rotary_only_ = false;
  drain_chain(true);
  double length = 0;
  for (const motion::Curve& curve : curves) length += curve.length();
  const Pace pace = pace_of(motion, feed, length);
  add_curves(curves, mark_of(motion, motion::MoveKind::cut, speed_at(pace, to)), drive_at(pace));
  at_ = to;
}

// A corner may leave either axis by so much, degrees counted as mm.
double PathBuilder::corner_tolerance(const motion::SurfaceMove& move) const {
  const bool face = move.surface.kind == motion::Surface::Kind::face;
  const double radius_mm =
      face ? std::fabs(at_[move.surface.first] - move.surface.centre_mm) : move.surface.radius_mm;
  return surface_tolerance_mm_ / std::max(1.0, geometry::radians(radius_mm));
}

// Smooth but for the turns of the rotary axis in the centre of a face, at rest.
void PathBuilder::add_surface_move(const Motion& motion, const motion::SurfaceMove& move) {
  const auto curves = curves_.of(at_, motion);
  if (curves.empty()) return;
  if (rotary_only_) stop();
  drain_chain(true);
  const bool face = move.surface.kind == motion::Surface::Kind::face;
  const auto turns = [&](const motion::Curve& curve) {
    return face && curve.is_line() && norms_.mm(curve.rate(0)) == 0 &&
           curve.length() == norms_.degrees(curve.end() - curve.at(0));
  };
  double length = 0;
  for (const motion::Curve& curve : curves) length += turns(curve) ? 0 : curve.length();
  const Pace pace = pace_of(motion, move.feed, length);
  bool joined = false;
  for (const motion::Curve& curve : curves) {
    const bool at_rest = turns(curve);
    if (at_rest) stop();
    rotary_only_ = at_rest;
    if (&curve == &curves.back())
      mark(curve.length(), mark_of(motion, motion::MoveKind::cut, speed_at(pace, move.to)));
    curve_tolerance_mm_ = corner_tolerance(move);
    const Drive turning{PathSpeed::constant(kInfinite), motion.fixed_override};
    add_curve(curve, at_rest ? turning : drive_at(pace), joined);
    at_ = curve.end();
    open_.tolerance_mm = corner_tolerance(move);
    joined = !at_rest;
    if (at_rest) stop();
  }
  rotary_only_ = false;
  curve_tolerance_mm_ = tolerance_mm_;
}

// The mark belongs to the last one.
void PathBuilder::add_curves(std::span<const motion::Curve> curves,
                             const motion::Mark& mark_of_last, const Drive& drive) {
  for (const motion::Curve& curve : curves) {
    if (&curve == &curves.back()) mark(curve.length(), mark_of_last);
    add_curve(curve, drive, false);
  }
}

void PathBuilder::add_dwell(const Motion& motion, double seconds) {
  stop();
  if (seconds > 0) emit_dwell(motion, seconds);
}

PathPiece& PathBuilder::emit_dwell(const Motion& motion, double seconds) {
  mark(0, mark_of(motion, motion::MoveKind::dwell));
  place_marks(path_.marks.end(), 0, 0);
  PathPiece& piece =
      emit(motion::Curve::line(at_, at_, 1, axes_.count()), 0, 1, {PathSpeed::constant(1)});
  piece.dwell_s = seconds;
  piece.stop = true;
  return piece;
}

// One for each spindle and piece: the last one counts.
void PathBuilder::note(const motion::SpindleTurn& turn) {
  if (!keeps_spindle_angle_) return;
  Ring<SpindleChange>& changes = path_.spindle_changes;
  const std::uint64_t next = path_.pieces.end();
  for (std::uint64_t n = changes.end(); n > changes.begin(); --n) {
    SpindleChange& other = changes[n - 1];
    if (other.piece < next) break;
    if (other.turn.spindle != turn.spindle) continue;
    other.turn = turn;
    return;
  }
  changes.push({next, turn});
}

// A cut begins when its spindles have their speeds, as with a control's signal of arrival.
void PathBuilder::await_spindles(const Motion& motion) {
  while (const auto arrival = spindles_.next_arrival()) {
    if (!keeps_spindle_angle_) continue;
    stop();
    PathPiece& piece = emit_dwell(motion, arrival->most_s);
    piece.until_speed = true;
    piece.spindle = arrival->spindle;
  }
}

// Threads in a row are one: no stop between them, and the speed of the spindle is that of the first
// one's begin, also with constant surface speed.
void PathBuilder::add_thread(const Motion& motion, const motion::Thread& thread) {
  const auto curves = curves_.of(at_, motion);
  if (curves.empty()) return;
  if (rotary_only_) stop();
  rotary_only_ = false;
  drain_chain(true);
  if (!in_thread_) begin_thread(motion, thread);
  const motion::ThreadWay way(thread, at_, axes_);
  const Drive drive{way.speed(thread_rpm_), true, true};
  const double speed = drive.speed.at(curves.front(), 0);
  add_curves(curves, mark_of(motion, motion::MoveKind::cut, speed), drive);
  at_ = thread.to;
  thread_stops_ = motion.exact_stop;
}

// It waits for the spindle's mark.
void PathBuilder::begin_thread(const Motion& motion, const motion::Thread& thread) {
  stop();
  in_thread_ = true;
  const motion::Spindle& spindle = spindles_.of_feed();
  thread_rpm_ = motion::rpm_at(spindle, at_) * spindles_.override_factor();
  if (!keeps_spindle_angle_ || !(thread_rpm_ > 0)) return;
  PathPiece& piece = emit_dwell(motion, 60 / thread_rpm_);
  piece.spindle = spindle.name;
  piece.mark_rpm = thread_rpm_;
  piece.mark_deg = thread.angle_deg;
}

void PathBuilder::end_thread() {
  in_thread_ = false;
  if (thread_stops_) stop();
}

void PathBuilder::drain_chain(bool ended) {
  if (chain_.empty()) return;
  ChainSmoother::Piece piece;
  while (chain_.next(ended, piece)) add_piece(piece);
}

void PathBuilder::add_piece(const ChainSmoother::Piece& piece) {
  const double begin = chain_.point(piece.first).way;
  for (std::uint64_t n = piece.first + 1; n <= piece.last; ++n)
    mark(chain_.point(n).way - begin, chain_.point(n).mark);
  const ChainSmoother::Point& first = chain_.point(piece.first + 1);
  add_curve(piece.curve, drive_at(first.pace), piece.joined, piece.begin_off_mm, piece.begin_turn,
            piece.end_turn);
}

// The marks of the curve stand already behind those of the open one.
void PathBuilder::add_curve(const motion::Curve& curve, const Drive& drive, bool joined,
                            double begin_off_mm, double begin_turn, double end_turn) {
  double begin = 0;
  if (is_open_ && joined) {
    close_open(false);
  } else if (is_open_) {
    const double most = kMostOfCurve * std::min(open_.curve.length(), curve.length());
    // What a smoothed chain leaves its lines near their end.
    const double near_it = 2 * most * std::max(open_.end_turn, begin_turn);
    const double used = std::min(kChainShare * tolerance_mm_, begin_off_mm + near_it);
    // Between the legs of a rapid the axes may go anywhere, if it is they that are driven.
    const bool free = rapid_ && !follower_.linked();
    const double tolerance_mm = std::min(open_.tolerance_mm, curve_tolerance_mm_) - used;
    const Passage passage{open_.drive.speed.at(open_.curve, open_.curve.length()),
                          drive.speed.at(curve, 0), most, free ? kInfinite : tolerance_mm};
    const Corner corner = corners_.between(open_.curve, curve, passage);
    if (corner.kind == Corner::Kind::rounded) {
      round(corner.rounding, drive_of_corner(curve, drive, passage));
      begin = corner.rounding.reach;
    } else {
      close_open(corner.kind == Corner::Kind::sharp);
    }
  }
  open_.curve = curve;
  open_.begin = begin;
  open_.drive = drive;
  open_.begin_turn = begin_turn;
  open_.end_turn = end_turn;
  open_.tolerance_mm = curve_tolerance_mm_;
  open_.last_mark = path_.marks.end();
  is_open_ = true;
}

void PathBuilder::close_open(bool with_stop) {
  place_marks(open_.last_mark, open_.curve.length(), 0);
  emit(open_.curve, open_.begin, open_.curve.length(), open_.drive).stop = with_stop;
  is_open_ = false;
}

// Between two curves, from the open one to the next. What a thread takes there is what both would.
PathBuilder::Drive PathBuilder::drive_of_corner(const motion::Curve& out, const Drive& drive,
                                                const Passage& passage) const {
  if (open_.drive.thread && drive.thread) {
    const double mean = 2 / (1 / passage.feed_in + 1 / passage.feed_out);
    return {PathSpeed::constant(mean), true, true};
  }
  const PathSpeed slower =
      PathSpeed::slower(open_.drive.speed, passage.feed_in, drive.speed, passage.feed_out);
  return {slower.times(std::max(pitch_of(open_.curve), pitch_of(out))), open_.drive.fixed_override};
}

void PathBuilder::round(const Rounding& rounding, const Drive& drive) {
  const double end = open_.curve.length() - rounding.reach;
  place_marks(open_.last_mark, end, 0);
  emit(open_.curve, open_.begin, end, open_.drive);
  place_marks(open_.last_mark, open_.curve.length(), -end);
  place_marks(path_.marks.end(), rounding.reach, rounding.reach);
  emit(rounding.curve, 0, rounding.curve.length(), drive).use = CellLimits::Use::corner;
}

// Gives the next marks, up to number `last` and parameter `up_to`, to the piece that comes next.
void PathBuilder::place_marks(std::uint64_t last, double up_to, double shift) {
  for (; placed_ < last && path_.marks[placed_].way <= up_to; ++placed_) {
    path_.marks[placed_].piece = path_.pieces.end();
    path_.marks[placed_].way += shift;
  }
}

// How much longer than its parameter a smooth curve is at most: its parameter counts the length of
// the lines that it stands for.
double PathBuilder::length_per_parameter(const motion::Curve& curve, double begin,
                                         double end) const {
  if (curve.is_line() || curve.is_arc() || curve.is_on_face() || rotary_only_) return 1;
  const double width = end - begin;
  double most = std::max({1.0, way_in_space(curve, begin), way_in_space(curve, begin + width)});
  constexpr double kClearly = 1 - 1e-9;
  const bool is_whole = begin == 0 && end == curve.length();
  if (is_whole && curve.is_cubic() && norms_.mm(curve.rate_between()) < kClearly * most)
    return most;  // it is nowhere more than at its ends
  constexpr int kPlaces = 8;
  for (int i = 1; i < kPlaces; ++i)
    most = std::max(most, way_in_space(curve, begin + width * i / kPlaces));
  return most;
}

// Way in space for a small step of the parameter.
double PathBuilder::way_in_space(const motion::Curve& curve, double at) const {
  return norms_.mm(curve.rate(at));
}

// The feed of a helix is that of its circle: its length in space for that of the circle.
double PathBuilder::pitch_of(const motion::Curve& curve) const {
  return curve.is_arc() ? std::max(1.0, way_in_space(curve, 0)) : 1;
}

PathPiece& PathBuilder::emit(const motion::Curve& curve, double begin, double end,
                             const Drive& drive) {
  PathPiece& piece = path_.pieces.push();
  piece.curve = curve;
  piece.begin = begin;
  piece.end = end;
  piece.speed = drive.speed.over(length_per_parameter(curve, begin, end));
  piece.dwell_s = piece.mark_rpm = 0;
  piece.until_speed = false;
  piece.use = CellLimits::Use::path;
  piece.rapid = rapid_;
  piece.fixed_override = drive.fixed_override;
  piece.thread = drive.thread;
  piece.stop = false;
  return piece;
}

void PathBuilder::mark(double way, const motion::Mark& mark) {
  path_.marks.push({std::numeric_limits<std::uint64_t>::max(), way, mark});
}

void PathBuilder::clear(const TipPoint& at) {
  at_ = at;
  chain_.start(at);
  is_open_ = rapid_ = in_thread_ = false;
  placed_ = path_.marks.end();
}

void PathBuilder::stop() {
  in_thread_ = false;
  drain_chain(true);
  if (is_open_) close_open(true);
}

}  // namespace kerf::planner
