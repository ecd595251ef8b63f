#pragma once

#include "math/math.hpp"

namespace kerf::geometry {

/// A point or vector of a plane. Units are the caller's (mm).
struct Vec2 {
  double u = 0;
  double v = 0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.u + b.u, a.v + b.v}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.u - b.u, a.v - b.v}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.u, -a.v}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.u, s * a.v}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double dot(Vec2 a, Vec2 b) { return a.u * b.u + a.v * b.v; }
/// Positive when `b` points to the left of `a`.
constexpr double cross(Vec2 a, Vec2 b) { return a.u * b.v - a.v * b.u; }
/// `a` turned by +90 degrees.
constexpr Vec2 left_of(Vec2 a) { return {-a.v, a.u}; }
inline double length(Vec2 a) { return math::hypot(a.u, a.v); }
/// `a` divided by its length, which must not be 0.
inline Vec2 unit(Vec2 a) { return (1.0 / length(a)) * a; }

}  // namespace kerf::geometry
