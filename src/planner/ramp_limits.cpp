#include "planner/ramp_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/profile.hpp"

namespace kerf::planner {
namespace {

// Of the most that is left of the jerk these shares are tried, close together where little is given
// away: 0.99, 0.98, 0.96, 0.92, 0.84, 0.73 and so on.
constexpr double kMostShare = 0.99;
constexpr double kLeastShare = 0.04;
double next_share(double share) { return share - std::min(0.13 * share, 1 - share); }

// Steps in which the acceleration is raised, the smallest of them as a share of the way, and how
// much nearer it ends when that is too large.
constexpr double kSteps = 16;
constexpr double kFinest = 1.0 / 512;
constexpr double kNearer = 64;

bool is_straight(const motion::CurveBounds& bounds, std::size_t axes) {
  for (std::size_t m = 0; m < axes; ++m) {
    if (bounds.second.values[m] > 0 || bounds.third.values[m] > 0) return false;
  }
  return true;
}

// What is left of the jerk where nothing is accelerated.
double most_jerk(const motion::CurveBounds& bounds, const AxisLimits& limits, std::size_t axes,
                 double speed) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < axes; ++m) {
    const double left = limits.jerk.values[m] - bounds.third.values[m] * speed * speed * speed;
    const double first = bounds.first.values[m];
    if (first > 0) least = std::min(least, left / first);
  }
  return least;
}

double most_acceleration(const motion::CurveBounds& bounds, const AxisLimits& limits,
                         std::size_t axes) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < axes; ++m) {
    const double first = bounds.first.values[m];
    if (first > 0) least = std::min(least, limits.acceleration.values[m] / first);
  }
  return least;
}

// Whether every axis can do this at once.
bool possible(const motion::CurveBounds& bounds, const AxisLimits& limits, std::size_t axes,
              double speed, const RampLimits& ramp) {
  const double square = speed * speed;
  for (std::size_t m = 0; m < axes; ++m) {
    const double first = bounds.first.values[m];
    const double second = bounds.second.values[m];
    if (first * ramp.acceleration + second * square > limits.acceleration.values[m]) return false;
    const double shape = speed * (3 * second * ramp.acceleration + bounds.third.values[m] * square);
    if (first * ramp.jerk + shape > limits.jerk.values[m]) return false;
  }
  return true;
}

// Between two steps both are at most what they are at its ends: the speed at the lower
// acceleration, the acceleration at the higher one.
double raised(double highest, double jerk, const motion::CurveBounds& bounds,
              const AxisLimits& limits, std::size_t axes, double speed) {
  double held = 0;
  for (double step = highest / kSteps; step > highest * kFinest;) {
    const double next = std::min(highest, held + step);
    const double slower = speed - held * held / (2 * jerk);
    if (possible(bounds, limits, axes, slower, {next, jerk})) {
      held = next;
      if (held == highest) break;
    } else {
      step /= 4;
    }
  }
  return held;
}

double acceleration_with(double jerk, double most, const motion::CurveBounds& bounds,
                         const AxisLimits& limits, std::size_t axes, double speed) {
  // A ramp from rest to the speed has no more.
  for (double highest = std::min(most, std::sqrt(jerk * speed)); highest > 0; highest /= kNearer) {
    const double held = raised(highest, jerk, bounds, limits, axes, speed);
    if (held > 0) return held;
  }
  return 0;
}

}  // namespace

RampLimits ramp_limits(const motion::CurveBounds& bounds, const AxisLimits& limits,
                       std::size_t axes, double speed) {
  const double jerk = most_jerk(bounds, limits, axes, speed);
  const double most = most_acceleration(bounds, limits, axes);
  if (is_straight(bounds, axes)) return {most, jerk};
  RampLimits best;
  double least_s = std::numeric_limits<double>::infinity();
  for (double share = kMostShare; share > kLeastShare; share = next_share(share)) {
    const auto time_s = [&](double acceleration) {
      return ramp_time_s(0, speed, {speed, acceleration, share * jerk});
    };
    if (time_s(most) >= least_s) break;  // with less jerk it is slower still
    const double acceleration = acceleration_with(share * jerk, most, bounds, limits, axes, speed);
    if (acceleration == 0 || time_s(acceleration) >= least_s) continue;
    least_s = time_s(acceleration);
    best = {acceleration, share * jerk};
  }
  return best;
}

}  // namespace kerf::planner
