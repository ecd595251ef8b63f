#include <algorithm>
#include <cmath>
#include <vector>

#include "drawing/fit.hpp"
#include "drawing/internal/bernstein.hpp"
#include "drawing/internal/bezier.hpp"
#include "drawing/internal/monotone.hpp"
#include "drawing/round_path.hpp"

namespace kerf::drawing {
namespace {

using Cubic = Bezier<4>;

template <std::size_t N>
using Polynomial = std::array<double, N>;

template <std::size_t N>
struct Hodograph {
  Polynomial<N> u;
  Polynomial<N> v;
};

template <std::size_t N>
Hodograph<N - 1> derivative(const Hodograph<N>& of) {
  Hodograph<N - 1> slope;
  derive(of.u, slope.u);
  derive(of.v, slope.v);
  return slope;
}

template <std::size_t A, std::size_t B>
Polynomial<A + B - 1> product(const Polynomial<A>& a, const Polynomial<B>& b) {
  Polynomial<A + B - 1> result;
  multiply(a, b, result);
  return result;
}

template <std::size_t A, std::size_t B>
Polynomial<A + B - 1> cross(const Hodograph<A>& a, const Hodograph<B>& b) {
  Polynomial<A + B - 1> left = product(a.u, b.v);
  const Polynomial<A + B - 1> right = product(a.v, b.u);
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= right[i];
  return left;
}

template <std::size_t A, std::size_t B>
Polynomial<A + B - 1> dot(const Hodograph<A>& a, const Hodograph<B>& b) {
  Polynomial<A + B - 1> left = product(a.u, b.u);
  const Polynomial<A + B - 1> right = product(a.v, b.v);
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += right[i];
  return left;
}

Hodograph<4> coordinates(const Cubic& cubic) {
  Hodograph<4> both;
  for (std::size_t i = 0; i < 4; ++i) {
    both.u[i] = cubic.points[i].u - cubic.points[0].u;
    both.v[i] = cubic.points[i].v - cubic.points[0].v;
  }
  return both;
}

/// On one line: it turns nowhere but where it stands for a moment.
bool is_straight(const Cubic& cubic) {
  const Vec2 chord = cubic.end() - cubic.begin();
  const double long_enough = geometry::length(chord);
  const Vec2 along = long_enough > kStraight_mm ? chord : cubic.begins();
  const double most = kStraight_mm * geometry::length(along);
  return std::all_of(cubic.points.begin(), cubic.points.end(), [&](Vec2 point) {
    return std::abs(geometry::cross(point - cubic.begin(), along)) <= most;
  });
}

/// Where it is to be parted, ascending: curvature 0 or extreme, of a straight one where it turns
/// back. With x' × x'' = N and |x'|² = D the curvature is N / D^1.5, whose slope has the sign of
/// N' D - 1.5 N D'.
void append_partings(const Cubic& cubic, std::vector<double>& places) {
  const Hodograph<3> first = derivative(coordinates(cubic));
  if (is_straight(cubic)) {
    const Vec2 along = cubic.begins();
    Polynomial<3> speed;
    for (std::size_t i = 0; i < 3; ++i) speed[i] = first.u[i] * along.u + first.v[i] * along.v;
    return append_sign_changes(speed, places);
  }
  const Hodograph<2> second = derivative(first);
  const Polynomial<4> turning = cross(first, second);
  const Polynomial<3> turning_slope = cross(first, derivative(second));
  const Polynomial<5> square = dot(first, first);
  const Polynomial<4> square_slope = dot(first, second);  // half of it
  Polynomial<7> curvature_slope = product(turning_slope, square);
  const Polynomial<7> less = product(turning, square_slope);
  for (std::size_t i = 0; i < less.size(); ++i) curvature_slope[i] -= 3 * less[i];
  append_sign_changes(turning, places);
  append_sign_changes(curvature_slope, places);
  std::sort(places.begin(), places.end());
}

/// A polynomial's largest absolute value, or a little more.
double bound(Coefficients of) {
  double most = 0;
  for (const double coefficient : of) most = std::max(most, std::abs(coefficient));
  return most;
}

// |B - c|² - r² bounds it, piece by piece.
double bound_by_parts(const Cubic& cubic, Vec2 centre, double radius, int parts) {
  if (parts > 0) {
    const auto [low, high] = cubic.halves();
    return std::max(bound_by_parts(low, centre, radius, parts - 1),
                    bound_by_parts(high, centre, radius, parts - 1));
  }
  Hodograph<4> away;
  for (std::size_t i = 0; i < 4; ++i) {
    away.u[i] = cubic.points[i].u - centre.u;
    away.v[i] = cubic.points[i].v - centre.v;
  }
  Polynomial<7> square = dot(away, away);
  for (double& coefficient : square) coefficient -= radius * radius;
  return way_from_square(bound(square), radius);
}

/// A cubic that stands for an arc of a circle: it touches it at both ends.
bool fit_arc(const Cubic& cubic, Fit& fit) {
  constexpr double kSameAngle = 1e-5;
  const Vec2 chord = cubic.end() - cubic.begin();
  if (geometry::length(chord) <= kStraight_mm) return false;
  const double from = half_tangent(cubic.begins(), chord);
  const double to = half_tangent(chord, cubic.ends());
  const double bulge = 0.5 * (from + to);
  if (std::abs(from - to) > kSameAngle || std::abs(bulge) > 1) return false;
  const double height = 0.5 * geometry::length(chord) * bulge;
  if (std::abs(height) <= kStraight_mm) return false;
  const double radius = geometry::length(chord) * (1 + bulge * bulge) / (4 * std::abs(bulge));
  const double centre_height = (1 - bulge * bulge) / (4 * bulge);
  const Vec2 centre =
      0.5 * (cubic.begin() + cubic.end()) + centre_height * geometry::left_of(chord);
  const double least = std::abs(geometry::length(cubic.parted(0.2).first.end() - centre) - radius);
  if (least > 0.1 * fit.tolerance) return false;  // as nearly always: it is no circle
  const double error = bound_by_parts(cubic, centre, radius, 4);
  if (!(error <= 0.1 * fit.tolerance)) return false;
  fit.error = std::max(fit.error, error);
  fit.steps.push_back({cubic.end(), bulge});
  return true;
}

}  // namespace

double distance_bound(const std::array<Vec2, 4>& points, Vec2 centre, double radius) {
  return bound_by_parts(Cubic{points}, centre, radius, 4);
}

void fit_cubic(const std::array<Vec2, 4>& points, Fit& fit) {
  Cubic rest{points};
  if (fit_arc(rest, fit)) return;
  thread_local std::vector<double> places;
  places.clear();
  append_partings(rest, places);
  double from = 0;
  for (const double place : places) {
    if (place <= from || place >= 1) continue;
    const auto [low, high] = rest.parted((place - from) / (1 - from));
    fit_monotone(low, fit);
    rest = high;
    from = place;
  }
  fit_monotone(rest, fit);
}

}  // namespace kerf::drawing
