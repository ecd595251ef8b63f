#include "planner/path_sampler.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "motion/turning_rapid.hpp"
#include "planner/steps.hpp"

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::TipPoint;

// The path as it is programmed: nothing is rounded, so no limit is ever asked.
Settings without_tolerance(Settings settings) {
  settings.tolerance_mm = 0;
  return settings;
}

AxisLimits no_limits() {
  AxisLimits limits;
  limits.velocity.values.fill(std::numeric_limits<double>::infinity());
  limits.acceleration = limits.jerk = limits.velocity;
  return limits;
}

}  // namespace

PathSampler::PathSampler(const motion::AxisSetup& axes, const Settings& settings)
    : axes_(axes),
      settings_(without_tolerance(settings)),
      limits_(no_limits(), settings_, axes.count(), {}),
      builder_(axes_, limits_, settings_, path_),
      tip_(axes.start) {
  assert(settings.sampling != Sampling::planned);
}

// A motion is whole when the piece that it ends in is there.
bool PathSampler::begin_motion() {
  if (path_.marks.empty() || path_.marks.front().piece >= path_.pieces.end()) return false;
  mark_ = path_.marks.front().mark;
  last_piece_ = path_.marks.front().piece;
  done_ = 0;
  literally_ = false;
  under_way_ = true;
  const PathPiece& first = path_.pieces.front();
  if (first.dwell_s > 0) {
    begin_dwell(first.dwell_s);
    return true;
  }
  double way = 0;
  double speed = std::numeric_limits<double>::infinity();
  for (std::uint64_t n = path_.pieces.begin(); n <= last_piece_; ++n) {
    way += way_of(path_.pieces[n].curve);
    speed = std::min(speed, speed_of(path_.pieces[n]));
  }
  const bool steps_apart =
      settings_.sampling == Sampling::literal && first.curve.is_line() && !first.rapid;
  if (steps_apart) divide_literally(way, speed);
  if (!literally_) divide(way, speed);
  return true;
}

void PathSampler::end_motion() {
  if (ends_ != nullptr) ends_->motion_ends(mark_.motion, time_s_);
  while (path_.pieces.begin() <= last_piece_) path_.pieces.pop();
  path_.marks.pop();
  tick_ += count_;
  begin_s_ = time_s_;
  under_way_ = false;
}

// Whole periods; where there are none, a point at its end.
void PathSampler::begin_dwell(double seconds) {
  count_ = is_periodic(settings_.sampling) ? count_steps(seconds, settings_.period_s) : 1;
  step_ = step_s_ = 0;
  length_s_ = seconds;
}

void PathSampler::divide(double way, double speed) {
  const double step =
      is_periodic(settings_.sampling) ? speed * settings_.period_s : settings_.step_mm;
  count_ = count_steps(way, step);
  const bool all_equal =
      settings_.sampling == Sampling::equal ||
      (settings_.sampling == Sampling::tail && turns_in_place(path_.pieces[last_piece_].curve));
  step_ = all_equal ? way / static_cast<double>(count_) : step;
  step_s_ = step / speed;
  length_s_ = way / speed;
}

// Points in equal times, as long as the line takes.
void PathSampler::divide_literally(double way, double speed) {
  const motion::Curve& line = path_.pieces[last_piece_].curve;
  literal_ = LiteralLine(line.at(0), line.end(), settings_.step_mm, axes_);
  count_ = literal_.count();
  length_s_ = way / speed;
  step_s_ = length_s_ / static_cast<double>(count_);
  literally_ = count_ > 0;
}

// Equal steps count an arc that changes its radius by the first one (docs/motion.md, "Equal
// steps").
double PathSampler::way_of(const motion::Curve& curve) const {
  return is_periodic(settings_.sampling) ? curve.length() : curve.length_at_first_radius();
}

// As fast as the axes go where there is no feed, and with a period also where only rotary axes turn
// (docs/motion.md, "Constant feed").
double PathSampler::speed_of(const PathPiece& piece) const {
  const double feed = piece.speed.mean(piece.curve, piece.begin, piece.end);
  const bool has_feed = std::isfinite(feed);
  if (has_feed && !(is_periodic(settings_.sampling) && turns_in_place(piece.curve)))
    return piece.fixed_override ? feed : feed * overrides_.feed;
  if (piece.rapid && axes_.turning_work) {
    const TipPoint begin = piece.curve.at(0);
    const double seconds = motion::TurningRapid::seconds(axes_, begin, piece.curve.end());
    if (seconds > 0) return piece.curve.length() / seconds * overrides_.rapid;
  }
  const AxisVector slope = piece.curve.bounds(piece.begin, piece.end).first;
  double speed = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < axes_.count(); ++m) {
    if (slope.values[m] > 0)
      speed = std::min(speed, axes_.axes[m].rapid_per_min / 60 / slope.values[m]);
  }
  return piece.rapid ? speed * overrides_.rapid : speed;
}

bool PathSampler::turns_in_place(const motion::Curve& curve) const {
  if (!curve.is_line()) return false;
  const AxisVector way = curve.end() - curve.at(0);
  for (std::size_t m = 0; m < axes_.count(); ++m) {
    if (!axes_.axes[m].rotary && way.values[m] != 0) return false;
  }
  return true;
}

TipPoint PathSampler::tip_at(std::uint64_t step) const {
  if (step == count_) return path_.pieces[last_piece_].curve.end();
  if (literally_) return literal_.at(step);
  double way = static_cast<double>(step) * step_;
  std::uint64_t n = path_.pieces.begin();
  for (; n < last_piece_ && way >= way_of(path_.pieces[n].curve); ++n)
    way -= way_of(path_.pieces[n].curve);
  const motion::Curve& curve = path_.pieces[n].curve;
  return curve.at(way * (curve.length() / way_of(curve)));
}

double PathSampler::time_at(std::uint64_t step) const {
  if (is_periodic(settings_.sampling))
    return static_cast<double>(tick_ + step) * settings_.period_s;
  return begin_s_ + (step == count_ ? length_s_ : static_cast<double>(step) * step_s_);
}

base::TipPoint PathSampler::motion_end() const {
  return under_way_ ? path_.pieces[last_piece_].curve.end() : tip_;
}

// Behind a block: nothing of it follows.
bool PathSampler::holds_here() const {
  if (hold_ != Hold::behind_block) return hold_ != Hold::none;
  if (under_way_ || mark_.motion == behind_motion_) return false;
  if (path_.marks.empty()) return true;
  const motion::Mark& next = path_.marks[path_.marks.begin()].mark;
  return next.block != mark_.block;
}

// Time passes where there is a period; without one there is nothing to tell.
bool PathSampler::stand(motion::Setpoint& point) {
  if (hold_ == Hold::reset) {
    if (under_way_) tick_ += done_;
    begin_s_ = time_s_;
    done_ = 0;
    under_way_ = false;
    path_.pieces.clear();
    path_.marks.clear();
    builder_.clear(tip_);
  }
  if (!is_periodic(settings_.sampling)) return false;
  ++tick_;
  time_s_ = time_at(under_way_ ? done_ : 0);
  point = {time_s_, tip_, mark_};
  return true;
}

void PathSampler::resume() {
  hold_ = Hold::none;
  held_ = false;
}

void PathSampler::reset() { hold_ = Hold::reset; }

bool PathSampler::next(motion::Setpoint& point) {
  held_ = holds_here();
  if (held_) return stand(point);
  if (!under_way_ && !begin_motion()) return false;
  ++done_;
  time_s_ = time_at(done_);
  tip_ = tip_at(done_);
  point = {time_s_, tip_, mark_};
  if (done_ == count_) end_motion();
  return true;
}

void PathSampler::skip() {
  while (under_way_ || begin_motion()) {
    time_s_ = time_at(count_);
    tip_ = tip_at(count_);
    end_motion();
  }
}

}  // namespace kerf::planner
