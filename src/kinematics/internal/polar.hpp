#pragma once

#include "geometry/angle.hpp"
#include "geometry/jet.hpp"
#include "math/math.hpp"

namespace kerf::kinematics {

/// A point of the plane by its distance from the middle and its direction from +X. Number is double
/// or geometry::Jet.
template <typename Number>
struct Polar {
  Number radius;
  Number bearing_deg;
};

/// Precondition for jets: the point is not the middle.
template <typename Number>
Polar<Number> polar(const Number& x, const Number& y) {
  using geometry::degrees;
  using math::atan2;
  using math::hypot;
  return {hypot(x, y), degrees(atan2(y, x))};
}

}  // namespace kerf::kinematics
