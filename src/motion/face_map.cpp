#include "motion/face_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::motion {
namespace {

using geometry::Vec2;

struct Complex {
  double re = 0;
  double im = 0;
};
Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

/// a/b as complex numbers.
Complex quotient(Vec2 a, Vec2 b) {
  const double square = dot(b, b);
  return {dot(b, a) / square, cross(b, a) / square};
}

struct Range {
  double low = 0;
  double high = 0;
  [[nodiscard]] double largest() const { return std::max(std::fabs(low), std::fabs(high)); }
};

/// Least and largest cos φ for φ in [low, high].
Range cosines(double low, double high) {
  const auto passes = [&](double angle) {
    const double turn = 2 * std::numbers::pi;
    return angle + std::ceil((low - angle) / turn) * turn <= high;
  };
  const auto [least, most] = std::minmax({math::cos(low), math::cos(high)});
  return {passes(std::numbers::pi) ? -1 : least, passes(0) ? 1 : most};
}

}  // namespace

FlatBounds bounds_of_line(Vec2 point, Vec2 slope, double from, double to) {
  const Vec2 a = point + from * slope;
  const Vec2 b = point + to * slope;
  FlatBounds bounds;
  bounds.speed = length(slope);
  bounds.turning = std::fabs(cross(a, slope));
  bounds.receding = std::max(std::fabs(dot(a, slope)), std::fabs(dot(b, slope)));
  bounds.farthest = std::max(length(a), length(b));
  const bool passes_foot = dot(a, slope) < 0 && dot(b, slope) > 0;
  bounds.nearest = passes_foot ? bounds.turning / bounds.speed : std::min(length(a), length(b));
  return bounds;
}

FlatBounds bounds_of_arc(Vec2 centre, const FlatArc& arc, double from, double to) {
  const double first = arc.radius + arc.radius_slope * from;
  const double last = arc.radius + arc.radius_slope * to;
  const double off = length(centre);
  const double peak = off > 0 ? math::atan2(centre.v, centre.u) : 0;
  const auto [low, high] =
      std::minmax({arc.angle_rad + arc.rate * from - peak, arc.angle_rad + arc.rate * to - peak});
  const Range along = cosines(low, high);
  constexpr double kQuarter = std::numbers::pi / 2;
  const double across = cosines(low - kQuarter, high - kQuarter).largest();
  const double radius = std::max(std::fabs(first), std::fabs(last));
  const double change = std::fabs(last - first);
  const double grow = std::fabs(arc.radius_slope);
  const double rate = std::fabs(arc.rate);
  const auto distance = [&](double cosine) {
    return std::sqrt(std::max(0.0, off * off + radius * (radius + 2 * off * cosine)));
  };
  const double reach =
      Range{radius + off * along.low, radius + off * along.high}.largest() + change;
  const auto from_centre = [&](double s, double r) {
    const math::SineCosine turned = math::sine_cosine(arc.angle_rad + arc.rate * s);
    return length(centre + r * Vec2{turned.cosine, turned.sine});
  };
  const auto [near_end, far_end] = std::minmax({from_centre(from, first), from_centre(to, last)});
  FlatBounds bounds;
  bounds.farthest = distance(along.high) + change;
  bounds.speed = math::hypot(radius * rate, grow);
  // Of what is small the sum of large squares says nothing.
  const double sure = std::clamp(far_end - bounds.speed * (to - from), 0.0, near_end);
  bounds.nearest = std::clamp(distance(along.low) - change, sure, near_end);
  bounds.turning = rate * radius * reach + grow * off;
  bounds.receding = rate * radius * off * across + grow * reach;
  bounds.bend = rate * math::hypot(radius * rate, 2 * grow);
  bounds.bend_turning = rate * (rate * radius * off * across + 2 * grow * bounds.farthest);
  bounds.bend_receding = rate * (rate * radius * reach + 2 * grow * bounds.farthest);
  bounds.third = rate * rate * (radius * rate + 3 * grow);
  return bounds;
}

base::TipPoint FaceMap::point(base::TipPoint flat_point) const {
  const Vec2 z = flat(flat_point);
  flat_point[first] = centre_mm + side * length(z);
  flat_point[rotary] = begin_deg + geometry::degrees(math::atan2(cross(begin, z), dot(begin, z)));
  return flat_point;
}

base::TipJet FaceMap::jet(const base::TipJet& flat_jet) const {
  const Vec2 z = flat(flat_jet.value);
  const Complex q = quotient(flat(flat_jet.first), z);
  const Complex second = quotient(flat(flat_jet.second), z);
  const Complex third = quotient(flat(flat_jet.third), z);
  const Complex q1 = second - q * q;
  const Complex q2 = third - 3 * (second * q) + 2 * (q * q * q);
  base::TipJet jet = flat_jet;
  jet.value = point(flat_jet.value);
  const double x = side * length(z);
  jet.first[first] = x * q.re;
  jet.second[first] = x * (q1.re + q.re * q.re);
  jet.third[first] = x * (q2.re + q.re * (3 * q1.re + q.re * q.re));
  jet.first[rotary] = geometry::degrees(q.im);
  jet.second[rotary] = geometry::degrees(q1.im);
  jet.third[rotary] = geometry::degrees(q2.im);
  return jet;
}

// ρ' = z·z'/ρ, c' = z×z'/ρ², ρ'' = z·z''/ρ + (z×z')²/ρ³, c'' = z×z''/ρ² - 2 c' ρ'/ρ. The third ones
// from the sums of |q| and its derivatives.
CurveBounds FaceMap::bounds(CurveBounds own, const FlatBounds& flat) const {
  const double r = flat.nearest;
  const double recede = std::min(flat.speed, flat.receding / r);
  const double turn = std::min(flat.speed, flat.turning / r) / r;
  own.first[first] = recede;
  own.first[rotary] = geometry::degrees(turn);
  own.second[first] = flat.bend_receding / r + turn * std::min(flat.speed, flat.turning / r);
  own.second[rotary] = geometry::degrees(flat.bend_turning / (r * r) + 2 * turn * recede / r);
  const double q = flat.speed / r;
  const double q1 = flat.bend / r + q * q;
  const double q2 = flat.third / r + q * (3 * flat.bend / r + 2 * q * q);
  own.third[first] = flat.farthest * (q2 + q * (3 * q1 + q * q));
  own.third[rotary] = geometry::degrees(q2);
  return own;
}

double FaceMap::bend(const CurveBounds& bounds, const FlatBounds& flat) const {
  return math::hypot(bounds.second[first],
                     flat.farthest * geometry::radians(bounds.second[rotary]));
}

}  // namespace kerf::motion
