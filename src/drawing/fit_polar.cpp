#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "drawing/fit.hpp"
#include "drawing/internal/bernstein.hpp"
#include "drawing/internal/monotone.hpp"

namespace kerf::drawing {
namespace {

using Terms = std::vector<double>;

Terms slope_of(const Terms& of, double factor) {
  Terms slope(of.size() - 1);
  derive(of, slope);
  for (double& coefficient : slope) coefficient *= factor;
  return slope;
}

Terms times(const Terms& a, const Terms& b) {
  Terms product(a.size() + b.size() - 1);
  multiply(a, b, product);
  return product;
}

/// a + factor · b, where b has a lower degree or the same.
Terms plus(Terms a, double factor, const Terms& b) {
  const Terms raised = times(b, Terms(a.size() - b.size() + 1, 1.0));
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * raised[i];
  return a;
}

/// Of r and its derivatives by the angle: the curvature is N / D^1.5 with N = r² + 2 r'² - r r''
/// and D = r² + r'², and its slope has the sign of N' D - 1.5 N D'.
std::vector<double> partings_of(const Polar& curve) {
  const double factor = 1 / (curve.to_rad - curve.from_rad);
  const Terms r(curve.radii.begin(), curve.radii.end());
  const Terms r1 = slope_of(r, factor);
  const Terms r2 = slope_of(r1, factor);
  const Terms square = times(r, r);
  const Terms n = plus(plus(square, 2, times(r1, r1)), -1, times(r, r2));
  const Terms d = plus(square, 1, times(r1, r1));
  const Terms left = times(slope_of(n, 1), d);
  const Terms right = times(n, slope_of(d, 1));
  std::vector<double> places;
  append_sign_changes(n, places);
  append_sign_changes(plus(left, -1.5, right), places);
  std::sort(places.begin(), places.end());
  return places;
}

Vec2 at_polar(double radius, double angle_rad) {
  return {radius * math::cos(angle_rad), radius * math::sin(angle_rad)};
}

/// A part of the curve as fit_monotone() wants it.
struct PolarPiece {
  Polar curve;

  [[nodiscard]] Vec2 begin() const { return at_polar(curve.radii[0], curve.from_rad); }
  [[nodiscard]] Vec2 end() const { return curve.end(); }
  [[nodiscard]] Vec2 begins() const {
    return direction(curve.radii[0], curve.radii[1] - curve.radii[0], curve.from_rad);
  }
  [[nodiscard]] Vec2 ends() const {
    return direction(curve.radii[3], curve.radii[3] - curve.radii[2], curve.to_rad);
  }
  [[nodiscard]] bool is_point() const { return curve.from_rad == curve.to_rad; }
  [[nodiscard]] std::pair<PolarPiece, PolarPiece> parted_at(double t) const {
    const auto& r = curve.radii;
    const auto between = [t](double a, double b) { return (1 - t) * a + t * b; };
    const double ab = between(r[0], r[1]);
    const double bc = between(r[1], r[2]);
    const double cd = between(r[2], r[3]);
    const double abc = between(ab, bc);
    const double bcd = between(bc, cd);
    const double middle = between(abc, bcd);
    const double angle = between(curve.from_rad, curve.to_rad);
    return {{{{r[0], ab, abc, middle}, curve.from_rad, angle}},
            {{{middle, bcd, cd, r[3]}, angle, curve.to_rad}}};
  }
  [[nodiscard]] std::pair<PolarPiece, PolarPiece> halves() const { return parted_at(0.5); }

 private:
  /// Outwards by r' and round by r, `third` being a third of what the radius gains.
  [[nodiscard]] Vec2 direction(double radius, double third, double angle_rad) const {
    const double width = curve.to_rad - curve.from_rad;
    const double way = width < 0 ? -1 : 1;
    return way * (at_polar(3 * third / width, angle_rad) +
                  geometry::left_of(at_polar(radius, angle_rad)));
  }
};

}  // namespace

void fit_polar(const Polar& curve, Fit& fit) {
  PolarPiece rest{curve};
  double from = 0;
  for (const double place : partings_of(curve)) {
    if (place <= from || place >= 1) continue;
    auto [low, high] = rest.parted_at((place - from) / (1 - from));
    fit_monotone(low, fit);
    rest = high;
    from = place;
  }
  fit_monotone(rest, fit);
}

}  // namespace kerf::drawing
