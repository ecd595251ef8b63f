#include "geometry/jet.hpp"

#include <cmath>

#include "math/math.hpp"

namespace kerf::geometry {
namespace {

/// The root of `square`, whose value is known: each order of root² = square, solved for its last
/// term.
Jet root(const Jet& square, double value) {
  Jet r;
  r.value = value;
  r.first = square.first / (2 * value);
  r.second = (square.second - 2 * r.first * r.first) / (2 * value);
  r.third = (square.third - 6 * r.first * r.second) / (2 * value);
  return r;
}

/// How fast `a` changes. Its own third derivative is not known and stands as 0.
Jet rate_of(const Jet& a) { return {a.first, a.second, a.third, 0}; }

}  // namespace

Jet sqrt(const Jet& a) { return root(a, std::sqrt(a.value)); }

Jet hypot(const Jet& x, const Jet& y) { return root(x * x + y * y, math::hypot(x.value, y.value)); }

// The angle changes by (x y' - y x') / (x² + y²).
Jet atan2(const Jet& y, const Jet& x) {
  const Jet rate = (x * rate_of(y) - y * rate_of(x)) / (x * x + y * y);
  return {math::atan2(y.value, x.value), rate.value, rate.first, rate.second};
}

SineCosineJet sine_cosine_deg(const Jet& angle_deg) {
  const auto [s, c] = sine_cosine_deg(angle_deg.value);
  const double a = radians(angle_deg.first);
  const double a2 = radians(angle_deg.second);
  const double a3 = radians(angle_deg.third);
  return {{s, c * a, c * a2 - s * a * a, c * (a3 - a * a * a) - 3 * s * a * a2},
          {c, -s * a, -s * a2 - c * a * a, -s * (a3 - a * a * a) - 3 * c * a * a2}};
}

}  // namespace kerf::geometry
