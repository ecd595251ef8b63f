#include "planner/profile.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::planner {

struct RampShape {
  double rise_s = 0;  // how long the acceleration rises, and falls
  double hold_s = 0;
  double acceleration = 0;  // what it rises to

  [[nodiscard]] double time_s() const { return 2 * rise_s + hold_s; }
  [[nodiscard]] double length(double from, double to) const { return (from + to) / 2 * time_s(); }
};

namespace {

bool jerk_limited(const PathLimits& limits) { return std::isfinite(limits.jerk); }

RampShape shape_of(double from, double to, const PathLimits& limits) {
  const double change = std::fabs(to - from);
  if (!jerk_limited(limits)) {
    if (change == 0) return {};
    const double fast = std::max(from, to);
    const double acceleration = limits.acceleration - limits.fall * fast * fast;
    return {0, change / acceleration, acceleration};
  }
  const double full = limits.acceleration * limits.acceleration / limits.jerk;
  if (change <= full) {
    const double rise_s = std::sqrt(change / limits.jerk);
    return {rise_s, 0, rise_s * limits.jerk};
  }
  const double rise_s = limits.acceleration / limits.jerk;
  return {rise_s, (change - full) / limits.acceleration, limits.acceleration};
}

// s = √Δv is the root of s³ + 2 v s = L √j (interpolation of the first kind, no hold): a cubic with
// one real root, by Cardano.
double change_without_hold(double from, double length, const PathLimits& limits) {
  const double p = 2 * from / 3;
  const double q = length * std::sqrt(limits.jerk) / 2;
  const double w = math::cbrt(q + std::sqrt(q * q + p * p * p));
  if (w == 0) return 0;
  // p/w is exact where w - p/w would cancel: s = w - p/w = 2q / (w² + p + (p/w)²).
  const double s = 2 * q / (w * w + p + (p / w) * (p / w));
  return s * s;
}

// Δv is the root of Δ² + Δ (2v + a²/j) + 2 v a²/j - 2 a L = 0.
double change_with_hold(double from, double length, const PathLimits& limits) {
  const double full = limits.acceleration * limits.acceleration / limits.jerk;
  const double half = from + full / 2;
  const double c = 2 * (from * full - limits.acceleration * length);
  return -c / (half + std::sqrt(half * half - c));
}

}  // namespace

double ramp_time_s(double from, double to, const PathLimits& limits) {
  return shape_of(from, to, limits).time_s();
}

double ramp_length(double from, double to, const PathLimits& limits) {
  return shape_of(from, to, limits).length(from, to);
}

double reachable_speed(double from, double length, const PathLimits& limits) {
  // v² = from² + 2 (a - fall v²) length, solved for v.
  if (!jerk_limited(limits)) {
    const double square = from * from + 2 * limits.acceleration * length;
    if (limits.fall == 0) return std::max(from, std::sqrt(square));
    return std::max(from, std::sqrt(square / (1 + 2 * limits.fall * length)));
  }
  const double full = limits.acceleration * limits.acceleration / limits.jerk;
  if (length <= ramp_length(from, from + full, limits))
    return from + change_without_hold(from, length, limits);
  return from + change_with_hold(from, length, limits);
}

// Mostly it is clear without a root that `most` is reached.
double reachable_speed(double from, double length, const PathLimits& limits, double most) {
  constexpr double kClearly = 1 + 1e-12;
  const double square = from * from + 2 * limits.acceleration * length;
  if (!jerk_limited(limits) && square > most * most * (1 + 2 * limits.fall * length) * kClearly)
    return most;
  return std::min(most, reachable_speed(from, length, limits));
}

namespace {

// The speed from which ramps to both ends together have the length.
double peak_speed(double length, double entry, double exit, const PathLimits& limits) {
  if (!jerk_limited(limits)) {
    const double square = (entry * entry + exit * exit) / 2 + limits.acceleration * length;
    const double slower = 1 + limits.fall * length;
    constexpr double kClearly = 1 + 1e-12;
    if (square > limits.velocity * limits.velocity * slower * kClearly) return limits.velocity;
    return std::min(limits.velocity, std::sqrt(square / slower));
  }
  const auto needed = [&](double peak) {
    return ramp_length(entry, peak, limits) + ramp_length(exit, peak, limits);
  };
  if (needed(limits.velocity) <= length) return limits.velocity;
  double low = std::max(entry, exit);
  double high = limits.velocity;
  for (int i = 0; i < 200; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (needed(middle) <= length ? low : high) = middle;
  }
  return low;
}

}  // namespace

Profile::Profile(double length, double entry, double exit, const PathLimits& limits)
    : peak_(std::max({peak_speed(length, entry, exit, limits), entry, exit})) {
  const RampShape up = shape_of(entry, peak_, limits);
  const RampShape down = shape_of(peak_, exit, limits);
  const double ramps = up.length(entry, peak_) + down.length(exit, peak_);
  // Ramps that are too long by rounding are driven a little faster: the way must be exact.
  const double share = ramps > length ? length / ramps : 1;
  add_ramp(entry, peak_, up, limits.jerk, share);
  if (ramps < length && peak_ > 0) add({(length - ramps) / peak_, peak_, 0, 0});
  add_ramp(peak_, exit, down, limits.jerk, share);
}

void Profile::add(const Phase& phase) {
  if (phase.duration_s <= 0) return;
  phases_[count_++] = phase;
  duration_s_ += phase.duration_s;
}

// `share` of the time, and so of the length, that the limits ask for.
void Profile::add_ramp(double from, double to, const RampShape& shape, double most_jerk,
                       double share) {
  if (share <= 0) return;
  const double side = to < from ? -1 : 1;
  const double jerk = shape.rise_s > 0 ? side * most_jerk / (share * share) : 0;
  const double acceleration = side * shape.acceleration / share;
  const double rise = side * shape.acceleration * shape.rise_s / 2;
  add({share * shape.rise_s, from, 0, jerk});
  add({share * shape.hold_s, from + rise, acceleration, 0});
  add({share * shape.rise_s, to - rise, acceleration, -jerk});
}

Profile::State Profile::state_at(double t_s) const {
  State state;
  double left_s = std::max(0.0, t_s);
  for (const Phase& phase : phases()) {
    const bool inside = left_s < phase.duration_s;
    const double t = inside ? left_s : phase.duration_s;
    state.position += phase.way(t);
    state.velocity = phase.velocity_at(t);
    state.acceleration = inside ? phase.acceleration_at(t) : 0;
    if (inside) break;
    left_s -= phase.duration_s;
  }
  return state;
}

}  // namespace kerf::planner
