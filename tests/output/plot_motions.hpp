#pragma once

#include <cstdint>
#include <string_view>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"

namespace kerf::output::testing {

/// Axes with these letters, in this order; A, B and C are rotary.
inline control::AxisSetup axes(std::string_view letters) {
  control::AxisSetup setup;
  for (const char letter : letters) {
    control::AxisConfig axis;
    axis.letter = letter;
    axis.rotary = letter == 'A' || letter == 'B' || letter == 'C';
    setup.axes.push_back(axis);
  }
  return setup;
}

inline control::Motion motion(const control::Motion::Action& action) {
  control::Motion result;
  result.action = action;
  return result;
}

// Of a machine whose axes are X, Y and Z, or, with two coordinates, X and Z.
inline base::AxisVector at(double a, double b, double c = 0) { return {{a, b, c}}; }

inline control::Motion rapid(double x, double y, double z = 0) {
  return motion(control::Rapid{at(x, y, z)});
}
inline control::Motion line(double x, double y, double z = 0) {
  return motion(control::Line{at(x, y, z), {}});
}
inline control::Motion tool(std::uint32_t number) { return motion(control::ToolChange{number}); }
inline control::Motion power(double percent) { return motion(control::Power{percent}); }

/// Counterclockwise in XY.
inline control::Motion arc(double x, double y, double z, double center_x, double center_y) {
  control::Arc result;
  result.to = at(x, y, z);
  result.center = {center_x, center_y};
  return motion(result);
}

/// Positions over the hole at height 2, drills to -10 and comes back up.
template <typename Sink>
void drill(Sink& sink, double x, double y) {
  sink.take(rapid(x, y, 2));
  sink.take(line(x, y, -10));
  sink.take(rapid(x, y, 2));
}

/// Numbers from 0 to 1, the same on every machine.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8) / 16777216.0;
  }

 private:
  std::uint32_t state_;
};

}  // namespace kerf::output::testing
