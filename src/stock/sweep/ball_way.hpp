#pragma once

#include <optional>

#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// The ball of a probe on its way: its centre goes along it, mm, frame of the stock. Radius 0: a
/// point.
struct BallWay {
  StraightWay way;
  double radius_mm = 0;
};

/// A ball that overlaps material by no more than this and does not go deeper has left it: rounding
/// must not make a probe stop that goes back from what it touched, or along it.
inline constexpr double kLeft_mm = 0.01;

/// Nothing of the ball is outside of it.
[[nodiscard]] Bounds bounds(const BallWay& ball);

/// The first t in [0, 1] at which the ball touches a box, which may be as thin as a plane, a line
/// or a point; nullopt: at none. 0 where it begins in it. Within 1e-9 mm of the gap between them. A
/// point meets only a box that has a size in every direction.
[[nodiscard]] std::optional<double> first_touch(const BallWay& ball, const Bounds& box);

}  // namespace kerf::stock
