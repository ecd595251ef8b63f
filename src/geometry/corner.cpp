#include "geometry/corner.hpp"

#include <cmath>

#include "geometry/arc.hpp"
#include "geometry/intersect.hpp"
#include "math/math.hpp"

namespace kerf::geometry {
namespace {

constexpr double kSmall = 1e-9;

Vec2 arc_direction(const Piece& piece, Vec2 point) {
  const Vec2 tangent = left_of(unit(point - piece.centre));
  return piece.clockwise ? -tangent : tangent;
}

// The piece moved to the left by `offset`, without ends. Radius below 0: nothing is left of it.
Curve offset_curve(const Piece& piece, Vec2 at, Vec2 direction, double offset) {
  if (!piece.is_arc) return {false, at + offset * left_of(direction), direction, 0};
  return {true, piece.centre, {}, length(at - piece.centre) + (piece.clockwise ? offset : -offset)};
}

// Where a circle about `centre` touches the piece.
Vec2 touching_point(const Piece& piece, Vec2 centre) {
  if (piece.is_arc) {
    return piece.centre + length(piece.from - piece.centre) * unit(centre - piece.centre);
  }
  const Vec2 d = direction_at_start(piece);
  return piece.from + dot(centre - piece.from, d) * d;
}

// Both points lie on the piece; true when `point` comes before its end and not before its
// beginning.
bool lies_on(const Piece& piece, Vec2 point) {
  if (!piece.is_arc) {
    const Vec2 d = piece.to - piece.from;
    const double along = dot(point - piece.from, d) / dot(d, d);
    return along >= -kSmall && along <= 1 + kSmall;
  }
  if (length(point - piece.from) < kSmall || length(point - piece.to) < kSmall) return true;
  return sweep_rad(piece.from, point, piece.centre, piece.clockwise) <=
         sweep_rad(piece.from, piece.to, piece.centre, piece.clockwise);
}

// The point of the piece at the straight distance `distance` from its end `at`; `sign` +1: forwards
// from its beginning, -1: back from its end.
std::optional<Vec2> point_at(const Piece& piece, Vec2 at, double distance, double sign) {
  Vec2 point;
  if (!piece.is_arc) {
    point = at + (sign * distance) * direction_at_start(piece);
  } else {
    const double radius = length(at - piece.centre);
    if (distance > 2 * radius) return std::nullopt;
    const double angle =
        2 * math::asin(distance / (2 * radius)) * sign * (piece.clockwise ? -1 : 1);
    const Vec2 arm = at - piece.centre;
    const auto [sine, cosine] = math::sine_cosine(angle);
    point = piece.centre + Vec2{arm.u * cosine - arm.v * sine, arm.u * sine + arm.v * cosine};
  }
  if (!lies_on(piece, point)) return std::nullopt;
  return point;
}

}  // namespace

Vec2 direction_at_start(const Piece& piece) {
  return piece.is_arc ? arc_direction(piece, piece.from) : unit(piece.to - piece.from);
}

Vec2 direction_at_end(const Piece& piece) {
  return piece.is_arc ? arc_direction(piece, piece.to) : unit(piece.to - piece.from);
}

bool is_smooth(const Piece& first, const Piece& second) {
  const Vec2 d1 = direction_at_end(first);
  const Vec2 d2 = direction_at_start(second);
  return std::fabs(cross(d1, d2)) < kSmall && dot(d1, d2) > 0;
}

std::optional<Blend> fillet(const Piece& first, const Piece& second, double radius) {
  const Vec2 corner = first.to;
  const Vec2 d1 = direction_at_end(first);
  const Vec2 d2 = direction_at_start(second);
  const bool clockwise = cross(d1, d2) < 0;
  const double side = clockwise ? -radius : radius;
  const Curve a = offset_curve(first, corner, d1, side);
  const Curve b = offset_curve(second, corner, d2, side);
  if (a.radius < 0 || b.radius < 0) return std::nullopt;
  const Intersections found = intersect(a, b, kSmall);
  if (found.count == 0) return std::nullopt;
  Vec2 centre = found.points[0];
  if (found.count == 2 && length(found.points[1] - corner) < length(centre - corner)) {
    centre = found.points[1];
  }
  const Blend blend{touching_point(first, centre), touching_point(second, centre), true, clockwise,
                    centre};
  if (!lies_on(first, blend.begin) || !lies_on(second, blend.end)) return std::nullopt;
  return blend;
}

std::optional<Blend> chamfer(const Piece& first, const Piece& second, double distance) {
  const auto begin = point_at(first, first.to, distance, -1);
  const auto end = point_at(second, second.from, distance, 1);
  if (!begin || !end) return std::nullopt;
  return Blend{*begin, *end, false, false, {}};
}

}  // namespace kerf::geometry
