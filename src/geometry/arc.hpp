#pragma once

#include <optional>

#include "geometry/vec2.hpp"

namespace kerf::geometry {

/// Centre of the arc of radius |radius| from `from` to `to` (docs/dialect.md ARC-5). The short way
/// round for radius > 0, the long way for radius < 0. When the chord is longer than the diameter by
/// at most 2·tolerance its midpoint is the centre; beyond that there is none. Precondition: from !=
/// to.
[[nodiscard]] std::optional<Vec2> centre_from_radius(Vec2 from, Vec2 to, double radius,
                                                     bool clockwise, double tolerance);

/// Angle swept from `from` to `to` about `centre` in the given direction, radians in (0, 2π]; the
/// same point is a full circle.
[[nodiscard]] double sweep_rad(Vec2 from, Vec2 to, Vec2 centre, bool clockwise);

/// Length of an arc whose radius changes linearly with the angle from that of `from` to that of
/// `to`, with `extra_turns` whole circles more and `rise` along the normal.
[[nodiscard]] double arc_length(Vec2 from, Vec2 to, Vec2 centre, bool clockwise,
                                unsigned extra_turns, double rise);

/// Largest angle of an arc of `radius` > 0 that leaves its chord by no more than `deviation` > 0,
/// radians in (0, π]: π where the radius is no larger than the deviation.
[[nodiscard]] double chord_angle_rad(double radius, double deviation);

}  // namespace kerf::geometry
