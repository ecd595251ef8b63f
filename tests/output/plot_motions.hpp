#pragma once

#include <cstdint>
#include <string_view>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::output::testing {

/// Axes with these letters, in this order; A, B and C are rotary.
inline motion::AxisSetup axes(std::string_view letters) {
  motion::AxisSetup setup;
  for (const char letter : letters) {
    motion::AxisConfig axis;
    axis.letter = letter;
    axis.rotary = letter == 'A' || letter == 'B' || letter == 'C';
    setup.axes.push_back(axis);
  }
  return setup;
}

/// Of a lathe: X is a diameter; with C its spindle is an axis.
inline motion::AxisSetup lathe_axes(std::string_view letters = "XZ") {
  motion::AxisSetup setup = axes(letters);
  setup.axes.front().diameter = true;
  return setup;
}

inline motion::Motion motion(const motion::Motion::Action& action) {
  motion::Motion result;
  result.action = action;
  return result;
}

// Of a machine whose axes are X, Y and Z, or, with two coordinates, X and Z.
inline base::TipPoint at(double a, double b, double c = 0) { return {{a, b, c}}; }

inline motion::Motion rapid(double x, double y, double z = 0) {
  return motion(motion::Rapid{at(x, y, z)});
}
inline motion::Motion line(double x, double y, double z = 0) {
  return motion(motion::Line{at(x, y, z), {}});
}
inline motion::Motion tool(std::uint32_t number) { return motion(motion::ToolChange{number}); }
inline motion::Motion power(double percent) { return motion(motion::Power{percent}); }

/// Counterclockwise in XY.
inline motion::Motion arc(double x, double y, double z, double center_x, double center_y) {
  motion::Arc result;
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
