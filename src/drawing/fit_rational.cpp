#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drawing/fit.hpp"
#include "drawing/internal/bernstein.hpp"
#include "drawing/internal/monotone.hpp"
#include "drawing/pen.hpp"

namespace kerf::drawing {
namespace {

using Series = std::vector<double>;

/// X, Y and W of a rational curve (X / W, Y / W).
struct Rational {
  Series x;
  Series y;
  Series w;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Vec2 point(std::size_t i) const { return {x[i] / w[i], y[i] / w[i]}; }
};

Series derivative(const Series& of) {
  if (of.size() < 2) return {0.0};
  Series slope(of.size() - 1);
  derive(of, slope);
  return slope;
}

Series product(const Series& a, const Series& b) {
  Series result(a.size() + b.size() - 1);
  multiply(a, b, result);
  return result;
}

/// a b + factor · c d, which have the same degree.
Series sum(const Series& a, const Series& b, double factor, const Series& c, const Series& d) {
  Series left = product(a, b);
  const Series right = product(c, d);
  for (std::size_t i = 0; i < left.size(); ++i) left[i] += factor * right[i];
  return left;
}

std::pair<Series, Series> parted(const Series& of, double t) {
  Series low(of.size());
  Series high = of;
  for (std::size_t i = 0; i < of.size(); ++i) {
    low[i] = high[0];
    for (std::size_t k = 0; k + 1 < of.size() - i; ++k)
      high[k] = (1 - t) * high[k] + t * high[k + 1];
  }
  return {low, high};
}

/// A part of the curve as fit_monotone() wants it.
struct RationalPiece {
  Rational curve;

  [[nodiscard]] Vec2 begin() const { return curve.point(0); }
  [[nodiscard]] Vec2 end() const { return curve.point(curve.size() - 1); }
  [[nodiscard]] Vec2 begins() const {
    for (std::size_t i = 1; i < curve.size(); ++i)
      if (is_far(curve.point(i), begin())) return curve.point(i) - begin();
    return end() - begin();
  }
  [[nodiscard]] Vec2 ends() const {
    for (std::size_t i = curve.size() - 1; i-- > 0;)
      if (is_far(curve.point(i), end())) return end() - curve.point(i);
    return end() - begin();
  }
  [[nodiscard]] bool is_point() const {
    for (std::size_t i = 1; i < curve.size(); ++i)
      if (is_far(curve.point(i), begin())) return false;
    return true;
  }
  [[nodiscard]] std::pair<RationalPiece, RationalPiece> parted_at(double t) const {
    auto [low_x, high_x] = parted(curve.x, t);
    auto [low_y, high_y] = parted(curve.y, t);
    auto [low_w, high_w] = parted(curve.w, t);
    return {{{std::move(low_x), std::move(low_y), std::move(low_w)}},
            {{std::move(high_x), std::move(high_y), std::move(high_w)}}};
  }
  [[nodiscard]] std::pair<RationalPiece, RationalPiece> halves() const { return parted_at(0.5); }

 private:
  static bool is_far(Vec2 a, Vec2 b) {
    constexpr double kNear_mm = 1e-9;
    return std::abs(a.u - b.u) > kNear_mm || std::abs(a.v - b.v) > kNear_mm;
  }
};

/// Where it is to be parted. (X/W)' = P/W² with P = X'W - XW', of which the direction is that of
/// the curve; the curvature is W² (P × P') / |P|³ but for a sign, and of N = W² (P × P') and D =
/// |P|² its slope has the sign of N' D - 1.5 N D'.
std::vector<double> partings(const Rational& curve) {
  const Series slope_w = derivative(curve.w);
  const Series px = sum(derivative(curve.x), curve.w, -1, slope_w, curve.x);
  const Series py = sum(derivative(curve.y), curve.w, -1, slope_w, curve.y);
  const Series turning = sum(px, derivative(py), -1, derivative(px), py);
  const Series bent = product(product(curve.w, curve.w), turning);
  const Series square = sum(px, px, 1, py, py);
  const Series curvature_slope = sum(derivative(bent), square, -1.5, derivative(square), bent);
  std::vector<double> places;
  append_sign_changes(turning, places);
  append_sign_changes(curvature_slope, places);
  append_sign_changes(px, places);  // of a straight one: where it turns back
  append_sign_changes(py, places);
  std::sort(places.begin(), places.end());
  return places;
}

/// Of an arc the way from its circle, squared and weighted, is nothing: |P - cW|² - r² W².
bool fit_circle(const RationalPiece& piece, Fit& fit) {
  constexpr double kSameAngle = 1e-5;
  const Vec2 chord = piece.end() - piece.begin();
  if (geometry::length(chord) <= kStraight_mm) return false;
  const double from = half_tangent(piece.begins(), chord);
  const double to = half_tangent(chord, piece.ends());
  const double bulge = 0.5 * (from + to);
  if (std::abs(from - to) > kSameAngle || std::abs(bulge) > 1) return false;
  if (0.5 * geometry::length(chord) * std::abs(bulge) <= kStraight_mm) return false;
  const double radius = geometry::length(chord) * (1 + bulge * bulge) / (4 * std::abs(bulge));
  const Vec2 centre = 0.5 * (piece.begin() + piece.end()) +
                      ((1 - bulge * bulge) / (4 * bulge)) * geometry::left_of(chord);
  Series x = piece.curve.x;
  Series y = piece.curve.y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] -= centre.u * piece.curve.w[i];
    y[i] -= centre.v * piece.curve.w[i];
  }
  const Series square = sum(x, x, 1, y, y);
  const Series weight = product(piece.curve.w, piece.curve.w);
  double most = 0;
  for (std::size_t i = 0; i < square.size(); ++i)
    most = std::max(most, std::abs(square[i] - radius * radius * weight[i]));
  const double least = *std::min_element(weight.begin(), weight.end());
  const double error = way_from_square(most / least, radius);
  if (!(error <= 0.1 * fit.tolerance)) return false;
  fit.error = std::max(fit.error, error);
  fit.steps.push_back({piece.end(), bulge});
  return true;
}

RationalPiece piece_about(Vec2 origin, std::span<const Weighted> points) {
  RationalPiece piece;
  for (const Weighted& point : points) {
    piece.curve.x.push_back((point.at.u - origin.u) * point.weight);
    piece.curve.y.push_back((point.at.v - origin.v) * point.weight);
    piece.curve.w.push_back(point.weight);
  }
  return piece;
}

void fit_whole(RationalPiece rest, Fit& fit) {
  if (fit_circle(rest, fit)) return;
  double from = 0;
  for (const double place : partings(rest.curve)) {
    if (place <= from || place >= 1) continue;
    auto [low, high] = rest.parted_at((place - from) / (1 - from));
    fit_monotone(low, fit);
    rest = std::move(high);
    from = place;
  }
  fit_monotone(rest, fit);
}

}  // namespace

void fit_rational(std::span<const Weighted> points, Fit& fit) {
  const Vec2 origin = points.front().at;  // about which numbers keep their last digits
  const std::size_t before = fit.steps.size();
  fit_whole(piece_about(origin, points), fit);
  for (std::size_t i = before; i < fit.steps.size(); ++i)
    fit.steps[i].to = fit.steps[i].to + origin;
}

}  // namespace kerf::drawing
