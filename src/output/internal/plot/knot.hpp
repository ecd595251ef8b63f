#pragma once

#include <array>

#include "output/internal/plot/space.hpp"

namespace kerf::output::plot {

/// A point of a path and how fast the tool passes it: X, Y, Z in mm, mm/min.
using Knot = std::array<double, 4>;
inline constexpr std::size_t kSpeed = 3;

inline Knot knot(const Point3& at, double speed) { return {at[kX], at[kY], at[kZ], speed}; }
inline Point3 place_of(const Knot& knot) { return {knot[kX], knot[kY], knot[kZ]}; }

}  // namespace kerf::output::plot
