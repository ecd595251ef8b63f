#include "planner/literal_line.hpp"

#include <algorithm>
#include <cmath>

#include "planner/steps.hpp"

namespace kerf::planner {

using base::AxisVector;
using base::TipPoint;

LiteralLine::LiteralLine(const TipPoint& from, const TipPoint& to, double step_mm,
                         const motion::AxisSetup& axes)
    : from_(from), to_(to), others_(to - from) {
  AxisVector in_plane;
  AxisVector up;
  const auto move = [&](char letter, AxisVector& into) {
    if (const auto axis = axes.find(letter))
      std::swap(into.values[base::index(*axis)], others_.values[base::index(*axis)]);
  };
  move('X', in_plane);
  move('Y', in_plane);
  move('Z', up);
  plane_ = chain(in_plane, step_mm);
  height_ = chain(up, step_mm);
  count_ = std::max(plane_.count, height_.count);
}

LiteralLine::Chain LiteralLine::chain(const AxisVector& way, double step_mm) {
  double square = 0;
  for (const double value : way.values) square += value * value;
  if (square == 0) return {};
  const double length = std::sqrt(square);
  Chain chain{{}, count_steps(length, step_mm)};
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    chain.step.values[m] = step_mm * (way.values[m] / length);
  return chain;
}

TipPoint LiteralLine::at(std::uint64_t n) const {
  if (n >= count_) return to_;
  const auto steps = static_cast<double>(n);
  TipPoint point;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m) {
    const double in_plane = plane_.step.values[m];
    const double up = height_.step.values[m];
    const bool arrived = (in_plane != 0 && n >= plane_.count) || (up != 0 && n >= height_.count);
    const double other = others_.values[m] * (steps / static_cast<double>(count_));
    point.values[m] = arrived ? to_.values[m] : from_.values[m] + steps * (in_plane + up) + other;
  }
  return point;
}

}  // namespace kerf::planner
