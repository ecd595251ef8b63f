#include "planner/cell_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/math.hpp"
#include "planner/chord.hpp"
#include "planner/ramp_limits.hpp"

namespace kerf::planner {
namespace {

// Of the chord, at the border between two bends that the tip leaves with some acceleration.
constexpr double kALittleLess = 0.95;

// Of G T⁴ in the bound of a linkage, and its largest share of the tolerance.
constexpr double kOfGain = 11.0 / 48;
constexpr double kMostOfGain = 0.25;

// Shares of the axes' limits that the shape of the path may use at full speed.
struct Shares {
  double acceleration, jerk;
};
constexpr Shares kPath{0.9, 0.7};
constexpr Shares kCorner{0.98, 0.98};

constexpr Shares shares(CellLimits::Use use) {
  return use == CellLimits::Use::corner ? kCorner : kPath;
}

// Of the tip, mm/s², in any direction.
double most_acceleration(const AxisLimits& limits, std::size_t axes,
                         const motion::LinearAxes& linear) {
  return motion::AxisNorms{linear, axes}.mm(limits.acceleration);
}

}  // namespace

CellLimits::CellLimits(const AxisLimits& axis_limits, const Settings& settings, std::size_t axes,
                       const motion::LinearAxes& linear)
    : limits_(axis_limits),
      chord_tolerance_mm_(settings.chord_tolerance_mm),
      period_s_(settings.period_s),
      acceleration_(most_acceleration(axis_limits, axes, linear)),
      axes_(axes),
      linear_(linear) {
  for (std::size_t m = 0; m < axes; ++m) jerk_limited_ |= std::isfinite(limits_.jerk.values[m]);
}

// The exact formula knows no limit for circles within the tolerance. But a curve that bends so
// sharply at one place may lead away from there.
double CellLimits::longest_chord(const CellBounds& bounds) const {
  const double curvature = bounds.curvature;
  if (bounds.linkage.gain > 0) return longest_linkage_chord(bounds);
  if (curvature == 0) return kInfinite;
  const double exact = longest_chord_mm(1 / curvature, chord_tolerance_mm_);
  // By rounding only it could be the longer one.
  constexpr double kHuge = 1e-12;
  const double height = curvature * chord_tolerance_mm_;
  if (height > kHuge && height < 1) return exact;
  return std::min(std::sqrt(8 * chord_tolerance_mm_ / curvature), exact);
}

// A chord is 2 √(δ (2R - δ)), which is √(4 δ R) or more where R > δ; elsewhere it is √(8 δ R).
bool CellLimits::is_chord_longer(const CellBounds& bounds, double chord) const {
  constexpr double kClearly = 1 + 1e-9;
  return bounds.linkage.gain == 0 &&
         4 * chord_tolerance_mm_ > kClearly * bounds.curvature * chord * chord;
}

bool CellLimits::turns_to_anything(const LinkageBend& linkage) const {
  const double square = period_s_ * period_s_;
  return kOfGain * linkage.gain * square * square > kMostOfGain * 8 * chord_tolerance_mm_;
}

// What the samples of a stretch show of the bend may be too much; more than the path's curvature
// and the swing together it never is. The chord of a circle has the part of the tolerance that its
// curvature has of the bend.
double CellLimits::longest_linkage_chord(const CellBounds& bounds) const {
  const LinkageBend& linkage = bounds.linkage;
  const double square = period_s_ * period_s_;
  const double most_bend = bounds.curvature + linkage.swing;
  double bend = std::clamp(linkage.bend, bounds.curvature, most_bend);
  double left = 8 * chord_tolerance_mm_;  // of 8 δ
  double half_swing = 0;                  // mm, of what is left over a chord
  if (turns_to_anything(linkage)) {
    bend = most_bend;
  } else {
    left -= kOfGain * linkage.gain * square * square;
    half_swing = std::sqrt(linkage.swing * linkage.gain) * square / 12;
  }
  const double divisor = half_swing + std::sqrt(half_swing * half_swing + bend * left);
  if (divisor == 0) return kInfinite;
  const double chord = left / divisor;
  if (bounds.curvature == 0) return chord;
  return std::min(chord,
                  longest_chord_mm(1 / bounds.curvature, bounds.curvature * chord * chord / 8));
}

// In a period, from rest: a T², mm.
double CellLimits::most_speed_up(const CellBounds& bounds) const {
  const double acceleration = std::max(bounds.tip_acceleration, acceleration_);
  return acceleration * period_s_ * period_s_;
}

double CellLimits::border_mm(const CellBounds& bounds) const {
  if (bounds.curvature == 0 || is_chord_longer(bounds, most_speed_up(bounds))) return 0;
  const double chord = longest_chord(bounds);
  return most_speed_up(bounds) > chord ? chord : 0;
}

double CellLimits::tolerable_speed(const CellBounds& bounds) const {
  const double chord = longest_chord(bounds);
  if (chord == kInfinite) return kInfinite;
  const double speed_up = most_speed_up(bounds);
  const bool at_border = bounds.at_border || turns_to_anything(bounds.linkage);
  if (!at_border || speed_up <= chord)
    return chord / std::sqrt(1 + std::min(1.0, speed_up / chord) / 64) / period_s_;
  if (speed_up <= 2 * chord) return kALittleLess * chord / period_s_;
  const double half = speed_up / 27;
  const double way = chord * chord / (half + std::sqrt(half * half + chord * chord));
  return std::min(chord / 2, way) / period_s_;
}

double CellLimits::acceleration_along(const base::AxisVector& first) const {
  double least = kInfinite;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double rate = std::fabs(first.values[m]);
    if (rate > 0) least = std::min(least, limits_.acceleration.values[m] / rate);
  }
  return std::isfinite(least) ? least : 0;
}

double CellLimits::highest_speed(const CellBounds& bounds, Use use) const {
  double speed = tolerable_speed(bounds);
  double square = kInfinite;
  double cube = kInfinite;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double first = bounds.driven.first.values[m];
    const double second = bounds.driven.second.values[m];
    const double third = bounds.driven.third.values[m];
    if (first > 0) speed = std::min(speed, limits_.velocity.values[m] / first);
    if (second > 0)
      square = std::min(square, shares(use).acceleration * limits_.acceleration.values[m] / second);
    if (third > 0 && jerk_limited_)
      cube = std::min(cube, shares(use).jerk * limits_.jerk.values[m] / third);
  }
  if (square < speed * speed) speed = std::min(speed, std::sqrt(square));
  return cube < kInfinite ? std::min(speed, math::cbrt(cube)) : speed;
}

double CellLimits::share_of_shape(const CellBounds& bounds, double speed) const {
  double most = 0;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double bend = bounds.driven.second.values[m] * speed * speed;
    const double bend_rate = bounds.driven.third.values[m] * speed * speed * speed;
    most =
        std::max({most, bend / limits_.acceleration.values[m], bend_rate / limits_.jerk.values[m]});
  }
  return most;
}

// Without a root or a quotient; what is nearly too fast counts as such.
bool CellLimits::allows(const CellBounds& bounds, double speed, Use use) const {
  constexpr double kClearly = 1 + 1e-9;
  constexpr double kOfSpeedUp = 1.01;  // more than what tolerable_speed() takes off for it
  if (!(speed < kInfinite) || jerk_limited_) return false;
  if (bounds.curvature > 0 && (!is_chord_longer(bounds, most_speed_up(bounds)) ||
                               !is_chord_longer(bounds, kOfSpeedUp * speed * period_s_)))
    return false;
  const double fast = kClearly * speed;
  for (std::size_t m = 0; m < axes_; ++m) {
    if (bounds.driven.first.values[m] * fast > limits_.velocity.values[m]) return false;
    if (bounds.driven.second.values[m] * fast * fast >
        shares(use).acceleration * limits_.acceleration.values[m])
      return false;
  }
  return bounds.linkage.gain == 0;
}

PathLimits CellLimits::of(const CellBounds& bounds, double feed, Use use) const {
  const double speed =
      allows(bounds, feed, use) ? feed : std::min(feed, highest_speed(bounds, use));
  return jerk_limited_ ? with_jerk(bounds.driven, speed) : without_jerk(bounds.driven, speed);
}

// The least of (A - q'' v²) / q' over the axes, each of them linear in v², is at least the line
// between its values at rest and at full speed.
PathLimits CellLimits::without_jerk(const motion::CurveBounds& bounds, double speed) const {
  double at_rest = kInfinite;
  double at_speed = kInfinite;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double first = bounds.first.values[m];
    if (!(first > 0)) continue;
    const double all = limits_.acceleration.values[m];
    const double taken = bounds.second.values[m] * speed * speed;
    at_rest = std::min(at_rest, all / first);
    at_speed = std::min(at_speed, (all - taken) / first);
  }
  PathLimits limits;
  limits.velocity = speed;
  limits.acceleration = at_rest;
  if (at_speed < at_rest) limits.fall = (at_rest - at_speed) / (speed * speed);
  return limits;
}

PathLimits CellLimits::with_jerk(const motion::CurveBounds& bounds, double speed) const {
  const RampLimits ramp = ramp_limits(bounds, limits_, axes_, speed);
  return {speed, ramp.acceleration, ramp.jerk};
}

}  // namespace kerf::planner
