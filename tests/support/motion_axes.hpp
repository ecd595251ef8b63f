#pragma once

#include <string_view>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "planner/setpoint_source.hpp"
#include "planner/settings.hpp"

namespace kerf::test {

/// Axes by their letters, A B C rotary, all with the same rapid rate.
inline motion::AxisSetup axes_named(std::string_view letters, double rapid_per_min = 10'000) {
  motion::AxisSetup setup;
  for (const char letter : letters) {
    motion::AxisConfig axis;
    axis.letter = letter;
    axis.rotary = letter >= 'A' && letter <= 'C';
    axis.rapid_per_min = rapid_per_min;
    setup.axes.push_back(axis);
  }
  return setup;
}

/// The same limits for every axis.
inline planner::AxisLimits equal_limits(double velocity, double acceleration, double jerk) {
  planner::AxisLimits limits;
  limits.velocity.values.fill(velocity);
  limits.acceleration.values.fill(acceleration);
  limits.jerk.values.fill(jerk);
  return limits;
}

/// Motions of one line each, from line 1.
inline std::vector<motion::Motion> motions_of(const std::vector<motion::Motion::Action>& actions) {
  std::vector<motion::Motion> motions;
  for (const auto& action : actions) {
    motion::Motion motion;
    motion.block.line = static_cast<std::uint32_t>(motions.size() + 1);
    motion.action = action;
    motions.push_back(motion);
  }
  return motions;
}

/// All set-points that a source makes of motions.
inline std::vector<motion::Setpoint> points_of(planner::SetpointSource& source,
                                               const std::vector<motion::Motion>& motions) {
  std::vector<motion::Setpoint> points;
  motion::Setpoint point;
  const auto drain = [&] {
    while (source.next(point)) points.push_back(point);
  };
  for (const motion::Motion& motion : motions) {
    if (!source.room()) drain();
    source.take(motion);
  }
  if (!source.room()) drain();
  source.finish();
  drain();
  return points;
}

/// Passes over all the set-points of motions.
inline void pass_over(planner::SetpointSource& source, const std::vector<motion::Motion>& motions) {
  for (const motion::Motion& motion : motions) {
    if (!source.room()) source.skip();
    source.take(motion);
  }
  if (!source.room()) source.skip();
  source.finish();
  source.skip();
}

}  // namespace kerf::test
