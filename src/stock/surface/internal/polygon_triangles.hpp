#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::stock::surface {

/// Numbers of points, counterclockwise.
using FlatTriangle = std::array<std::uint32_t, 3>;

/// Divides a polygon with holes into triangles by cutting off its ears; every side of it is a side
/// of exactly one of them. `loops`: numbers into `points`, the first counterclockwise around it,
/// the others clockwise around its holes. Sides do not cross. The time grows with the square of the
/// number of corners only where most of them point inwards close to each other.
[[nodiscard]] std::vector<FlatTriangle> triangles_of(const std::vector<geometry::Vec2>& points,
                                                     std::vector<std::vector<std::uint32_t>> loops);

}  // namespace kerf::stock::surface
