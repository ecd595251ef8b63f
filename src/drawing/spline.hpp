#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/pen.hpp"

namespace kerf::drawing {

/// A curve of rational pieces by points that pull at it. Of its knots, which do not descend, those
/// from number `degree` to the last but `degree` are the curve's.
struct Spline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Weighted> points;
};
inline constexpr int kLargestDegree = 10;

/// Why it is none, as the end of a sentence; empty: it is one.
[[nodiscard]] std::string fault_of(const Spline& spline);
/// Where it begins.
[[nodiscard]] Vec2 begin_of(const Spline& spline);
/// Draws it as Bezier pieces, which are the same curve. The pen goes on from where it stands, which
/// is begin_of(); where the spline jumps another path begins.
void draw(const Spline& spline, Pen& pen);

/// A cubic with two steady derivatives through points, whose parameter is the length of the chords.
struct Through {
  std::vector<Vec2> points;      ///< two or more, no two neighbours the same; closed: three or more
  std::optional<Vec2> begins{};  ///< directions; none: curvature 0 there
  std::optional<Vec2> ends{};
  bool is_closed = false;  ///< the last point leads to the first in the same way
};
/// Takes out points that are the same as the one before; a closed one's last that is its first.
void take_out_twins(Through& through);
/// The pen stands on the first point.
void draw(const Through& through, Pen& pen);

}  // namespace kerf::drawing
