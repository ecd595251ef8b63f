#pragma once

#include "geometry/angle.hpp"

namespace kerf::geometry {

/// A number that changes along a path: its value and its first three derivatives by the parameter
/// of the path. A formula that is written on jets gives its derivatives with its value, exact but
/// for rounding: this is the arithmetic of Taylor series that are cut off behind the third power.
///
/// A number that does not change is a jet of nothing but a value. Value type; nothing allocates.
struct Jet {
  double value = 0;
  double first = 0;
  double second = 0;
  double third = 0;

  friend constexpr bool operator==(const Jet&, const Jet&) = default;

  friend constexpr Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second, a.third + b.third};
  }
  friend constexpr Jet operator-(const Jet& a, const Jet& b) {
    return {a.value - b.value, a.first - b.first, a.second - b.second, a.third - b.third};
  }
  friend constexpr Jet operator*(double s, const Jet& a) {
    return {s * a.value, s * a.first, s * a.second, s * a.third};
  }
  friend constexpr Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second,
            a.third * b.value + 3 * (a.second * b.first + a.first * b.second) + a.value * b.third};
  }
  /// Precondition: b.value is not 0. Each order of a = quotient * b, solved for its last term.
  friend constexpr Jet operator/(const Jet& a, const Jet& b) {
    Jet q;
    q.value = a.value / b.value;
    q.first = (a.first - q.value * b.first) / b.value;
    q.second = (a.second - 2 * q.first * b.first - q.value * b.second) / b.value;
    q.third =
        (a.third - 3 * (q.second * b.first + q.first * b.second) - q.value * b.third) / b.value;
    return q;
  }

  friend constexpr Jet operator-(const Jet& a) { return -1.0 * a; }
  friend constexpr Jet operator+(const Jet& a, double s) { return a + Jet{s}; }
  friend constexpr Jet operator-(const Jet& a, double s) { return a - Jet{s}; }
  friend constexpr Jet operator-(double s, const Jet& a) { return Jet{s} - a; }
};

constexpr Jet degrees(const Jet& angle_rad) { return degrees(1.0) * angle_rad; }

/// Precondition: a.value > 0.
[[nodiscard]] Jet sqrt(const Jet& a);

/// √(x² + y²). Precondition: not both values are 0.
[[nodiscard]] Jet hypot(const Jet& x, const Jet& y);

/// Angle of (x, y) from +X, radians. Precondition: not both values are 0.
[[nodiscard]] Jet atan2(const Jet& y, const Jet& x);

/// Sine and cosine of an angle in degrees; their values are exact at multiples of 90.
struct SineCosineJet {
  Jet sine;
  Jet cosine;
};
[[nodiscard]] SineCosineJet sine_cosine_deg(const Jet& angle_deg);

}  // namespace kerf::geometry
