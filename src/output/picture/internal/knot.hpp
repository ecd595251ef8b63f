#pragma once

#include <array>

#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// A point of a path and what is shown of the cut there: X, Y, Z in mm, a value of a CutMeasure.
using Knot = std::array<double, 4>;
inline constexpr std::size_t kValue = 3;

inline Knot knot(const Point3& at, double value) { return {at[kX], at[kY], at[kZ], value}; }
inline Point3 place_of(const Knot& knot) { return {knot[kX], knot[kY], knot[kZ]}; }

}  // namespace kerf::output::plot
