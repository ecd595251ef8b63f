#pragma once

#include <variant>

#include "geometry/vec3.hpp"

namespace kerf::stock {

using geometry::Vec3;

// Ways of the tip of a tool through the frame of the stock, mm. t runs from 0 to 1 over each, at a
// constant share of its length.

/// Straight; `from` and `to` may be the same place.
struct StraightWay {
  Vec3 from;
  Vec3 to;
};

/// A circle that everything else is linear over: arcs, helices, spirals.
///
///   P(t) = centre + t rise + (radius + t radius_change)(e1 cos φ + e2 sin φ),  φ = angle + t turn
///
/// e1 and e2 are perpendicular unit vectors; angle and turn in radians, `turn` of any size and
/// sign, not 0.
struct ArcWay {
  Vec3 centre;
  Vec3 rise;
  Vec3 e1;
  Vec3 e2;
  double radius = 0;
  double radius_change = 0;
  double angle_rad = 0;
  double turn_rad = 0;
};

/// From one pose to another: every point of the tool goes straight. Whoever makes them has divided
/// the true way so that this is as near to it as spec and tolerance want (turning_steps()).
struct TurningWay {
  Vec3 from;
  Vec3 to;
  Vec3 to_axis;  ///< unit, as Sweep::axis; that is the one at the beginning
};

using Way = std::variant<StraightWay, ArcWay, TurningWay>;

/// Where the tip is at t in [0, 1].
[[nodiscard]] Vec3 point_at(const StraightWay& way, double t);
[[nodiscard]] Vec3 point_at(const ArcWay& way, double t);
[[nodiscard]] Vec3 point_at(const TurningWay& way, double t);
[[nodiscard]] Vec3 point_at(const Way& way, double t);

/// Length of the tip's way.
[[nodiscard]] double length(const Way& way);

/// The part of a way between two t. from < to.
[[nodiscard]] StraightWay part(const StraightWay& way, double from, double to);
[[nodiscard]] ArcWay part(const ArcWay& way, double from, double to);

/// A box along the three axes.
struct Bounds {
  Vec3 low;
  Vec3 high;

  friend bool operator==(const Bounds&, const Bounds&) = default;
};
/// Holds every point of the tip's way; that of an arc with a rise or a change of radius may be
/// larger than need be.
[[nodiscard]] Bounds bounds(const Way& way);

}  // namespace kerf::stock
