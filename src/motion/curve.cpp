#include "motion/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "math/math.hpp"

namespace kerf::motion {
namespace {

using base::AxisVector;
using base::TipJet;
using base::TipPoint;

// Degree of the highest polynomial.
constexpr std::size_t kHighest = 5;

/// Bernstein's form of a polynomial on [0, 1]: b_i = Σ_k C(i,k) / C(degree,k) c_k, k <= i <=
/// degree.
template <std::size_t degree>
using Weights = std::array<std::array<double, degree + 1>, degree + 1>;

template <std::size_t degree>
constexpr Weights<degree> weights_of_powers() {
  Weights<degree> weights{};
  for (std::size_t i = 0; i <= degree; ++i) {
    weights[i][0] = 1;
    for (std::size_t k = 1; k <= i; ++k) {
      const double share = static_cast<double>(i - k + 1) / static_cast<double>(degree - k + 1);
      weights[i][k] = weights[i][k - 1] * share;
    }
  }
  return weights;
}

template <std::size_t degree>
constexpr Weights<degree> kWeights = weights_of_powers<degree>();

/// Largest absolute value on [0, width] of a polynomial with so many coefficients, from those in
/// Bernstein's form of a degree that may be higher than its own: they bound it, the closer the
/// higher the degree is, and are the value itself at both ends.
template <std::size_t degree, std::size_t count>
double largest(std::array<double, count> c, double width) {
  double power = width;
  for (std::size_t k = 1; k < count; ++k, power *= width) c[k] *= power;
  double most = std::fabs(c[0]);
  // Those of a line lie between the first and the last one.
  for (std::size_t i = count <= 2 ? degree : 1; count > 1 && i <= degree; ++i) {
    double b = c[0];
    for (std::size_t k = 1; k < count && k <= i; ++k) b += kWeights<degree>[i][k] * c[k];
    most = std::max(most, std::fabs(b));
  }
  return most;
}

/// The same polynomial with its origin at `at`.
template <std::size_t count>
void shift(std::array<double, count>& c, double at) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t k = count - 1; k-- > i;) c[k] += at * c[k + 1];
  }
}

template <std::size_t count>
std::array<double, count - 1> derivative(const std::array<double, count>& c) {
  std::array<double, count - 1> d;
  for (std::size_t k = 1; k < count; ++k) d[k - 1] = static_cast<double>(k) * c[k];
  return d;
}

/// Value and derivatives of a polynomial with so many coefficients, those divided by 1, 2 and 6.
template <std::size_t count>
std::array<double, 4> taylor(const std::array<double, count>& c, double s) {
  std::array<double, 4> t{c[count - 1], 0, 0, 0};
  for (std::size_t k = count - 1; k-- > 0;) {
    t[3] = t[2] + s * t[3];
    t[2] = t[1] + s * t[2];
    t[1] = t[0] + s * t[1];
    t[0] = c[k] + s * t[0];
  }
  return t;
}

/// Angles from `low` to `high`. What is at its rims is worked out when it is asked for.
struct Sector {
  struct Rim {
    double angle_rad;
    std::optional<math::SineCosine> turned{};

    [[nodiscard]] double swing(double a, double b) {
      if (!turned) turned = math::sine_cosine(angle_rad);
      return std::fabs(a * turned->cosine + b * turned->sine);
    }
  };
  Rim low, high;

  [[nodiscard]] bool is_half() const { return high.angle_rad - low.angle_rad >= std::numbers::pi; }
};

// Mostly one of both is 0, because arcs lie in the plane of two axes: what the functions are then.
double amplitude_of(double a, double b) {
  return a == 0 || b == 0 ? std::fabs(a + b) : math::hypot(a, b);
}
double peak_of(double a, double b) {
  if (a == 0) return std::copysign(std::numbers::pi / 2, b);
  return a > 0 && b == 0 ? 0 : math::atan2(b, a);
}

/// Largest |a cos φ + b sin φ| for φ in the sector.
double largest_swing(double a, double b, Sector& sector) {
  if (a == 0 && b == 0) return 0;
  const double amplitude = amplitude_of(a, b);
  if (sector.is_half()) return amplitude;
  const double peak = peak_of(a, b);
  const double first = std::ceil((sector.low.angle_rad - peak) / std::numbers::pi);
  if (peak + first * std::numbers::pi <= sector.high.angle_rad) return amplitude;
  return std::max(sector.low.swing(a, b), sector.high.swing(a, b));
}

}  // namespace

Curve::Curve(Kind kind, const TipPoint& end, double length, std::size_t axes)
    : kind_(kind), axes_(static_cast<std::uint8_t>(axes)), length_(length), end_(end) {}

Curve Curve::line(const TipPoint& from, const TipPoint& to, double length, std::size_t axes) {
  Curve curve(Kind::line, to, length, axes);
  curve.c_[0] = from;
  for (std::size_t m = 0; m < axes; ++m)
    curve.c_[1].values[m] = (to.values[m] - from.values[m]) / length;
  return curve;
}

Curve Curve::hermite(const TipJet& from, const TipJet& to, double length, std::size_t axes) {
  Curve curve(Kind::quintic, to.value, length, axes);
  const double l = length;
  for (std::size_t m = 0; m < axes; ++m) {
    const double p = from.value.values[m];
    const double v = from.first.values[m];
    const double a = from.second.values[m];
    // What is missing at the end without the three highest terms.
    const double d0 = (to.value.values[m] - (p + l * (v + l * a / 2))) / (l * l * l);
    const double d1 = (to.first.values[m] - (v + l * a)) / (l * l);
    const double d2 = (to.second.values[m] - a) / l;
    curve.c_[0].values[m] = p;
    curve.c_[1].values[m] = v;
    curve.c_[2].values[m] = a / 2;
    curve.c_[3].values[m] = 10 * d0 - 4 * d1 + d2 / 2;
    curve.c_[4].values[m] = (-15 * d0 + 7 * d1 - d2) / l;
    curve.c_[5].values[m] = (6 * d0 - 3 * d1 + d2 / 2) / (l * l);
  }
  return curve;
}

Curve Curve::cubic(const TipJet& from, const TipJet& to, double length, std::size_t axes) {
  Curve curve(Kind::cubic, to.value, length, axes);
  for (std::size_t m = 0; m < axes; ++m) {
    const double v = from.first.values[m];
    const double d0 = (to.value.values[m] - from.value.values[m]) / length - v;
    const double d1 = to.first.values[m] - v;
    curve.c_[0].values[m] = from.value.values[m];
    curve.c_[1].values[m] = v;
    curve.c_[2].values[m] = (3 * d0 - d1) / length;
    curve.c_[3].values[m] = (d1 - 2 * d0) / (length * length);
  }
  return curve;
}

Curve Curve::arc(const ArcShape& shape, const TipPoint& to, double length, std::size_t axes) {
  Curve curve(Kind::arc, to, length, axes);
  curve.c_[0] = shape.origin;
  curve.c_[1] = shape.slope;
  curve.c_[2] = shape.e1;
  curve.c_[3] = shape.e2;
  curve.radius_ = shape.radius;
  curve.radius_slope_ = shape.radius_slope;
  curve.angle_rad_ = shape.angle_rad;
  curve.rate_ = shape.rate;
  return curve;
}

Curve Curve::on_face(const Curve& flat, const FaceMap& map, const TipPoint& to) {
  Curve curve = flat;
  curve.on_face_ = true;
  curve.map_ = map;
  curve.end_ = to;
  return curve;
}

double Curve::length_at_first_radius() const {
  return is_arc() ? radius_ * std::fabs(rate_) * length_ : length_;
}

TipPoint Curve::at(double s) const {
  if (s >= length_) return end_;
  return on_face_ ? map_.point(point(s)) : point(s);
}

TipPoint Curve::point(double s) const {
  TipPoint p;
  switch (kind_) {
    case Kind::line:
      for (std::size_t m = 0; m < axes_; ++m) p.values[m] = c_[0].values[m] + s * c_[1].values[m];
      break;
    case Kind::cubic:
      for (std::size_t m = 0; m < axes_; ++m) p.values[m] = taylor(coefficients<4>(m), s)[0];
      break;
    case Kind::quintic:
      for (std::size_t m = 0; m < axes_; ++m) p.values[m] = taylor(coefficients<6>(m), s)[0];
      break;
    case Kind::arc: {
      const double angle = angle_rad_ + rate_ * s;
      const double radius = radius_ + radius_slope_ * s;
      const math::SineCosine turned = math::sine_cosine(angle);
      const double u = radius * turned.cosine;
      const double v = radius * turned.sine;
      for (std::size_t m = 0; m < axes_; ++m) {
        p.values[m] =
            c_[0].values[m] + s * c_[1].values[m] + u * c_[2].values[m] + v * c_[3].values[m];
      }
      break;
    }
  }
  return p;
}

AxisVector Curve::rate(double s) const {
  if (on_face_) return jet(s).first;
  if (s == 0 && kind_ != Kind::arc) return c_[1];
  AxisVector rate;
  switch (kind_) {
    case Kind::line: return c_[1];
    case Kind::cubic:
      for (std::size_t m = 0; m < axes_; ++m) rate.values[m] = taylor(coefficients<4>(m), s)[1];
      break;
    case Kind::quintic:
      for (std::size_t m = 0; m < axes_; ++m) rate.values[m] = taylor(coefficients<6>(m), s)[1];
      break;
    case Kind::arc: return arc_jet(s).first;
  }
  return rate;
}

// The middle coefficient of c1 + 2 c2 s + 3 c3 s² in Bernstein's form over the curve.
AxisVector Curve::rate_between() const {
  AxisVector rate;
  for (std::size_t m = 0; m < axes_; ++m)
    rate.values[m] = c_[1].values[m] + length_ * c_[2].values[m];
  return rate;
}

TipJet Curve::jet(double s) const {
  TipJet jet = on_face_ ? map_.jet(own_jet(s)) : own_jet(s);
  if (s >= length_) jet.value = end_;
  return jet;
}

TipJet Curve::own_jet(double s) const {
  TipJet jet;
  switch (kind_) {
    case Kind::line:
      jet.value = point(s);
      jet.first = c_[1];
      break;
    case Kind::cubic: jet = polynomial_jet<4>(s); break;
    case Kind::quintic: jet = polynomial_jet<6>(s); break;
    case Kind::arc: jet = arc_jet(s); break;
  }
  return jet;
}

template <std::size_t count>
std::array<double, count> Curve::coefficients(std::size_t axis) const {
  std::array<double, count> c;
  for (std::size_t k = 0; k < count; ++k) c[k] = c_[k].values[axis];
  return c;
}

template <std::size_t count>
TipJet Curve::polynomial_jet(double s) const {
  TipJet jet;
  for (std::size_t m = 0; m < axes_; ++m) {
    const auto [value, first, second, third] = taylor(coefficients<count>(m), s);
    jet.value.values[m] = value;
    jet.first.values[m] = first;
    jet.second.values[m] = 2 * second;
    jet.third.values[m] = 6 * third;
  }
  return jet;
}

TipJet Curve::arc_jet(double s) const {
  const double angle = angle_rad_ + rate_ * s;
  const auto [sine, cosine] = math::sine_cosine(angle);
  const double r = radius_ + radius_slope_ * s;
  const double w = rate_;
  TipJet jet;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double out = c_[2].values[m] * cosine + c_[3].values[m] * sine;    // away from the centre
    const double along = c_[3].values[m] * cosine - c_[2].values[m] * sine;  // its derivative by φ
    jet.value.values[m] = c_[0].values[m] + s * c_[1].values[m] + r * out;
    jet.first.values[m] = c_[1].values[m] + radius_slope_ * out + r * w * along;
    jet.second.values[m] = 2 * radius_slope_ * w * along - r * w * w * out;
    jet.third.values[m] = -3 * radius_slope_ * w * w * out - r * w * w * w * along;
  }
  return jet;
}

CurveBounds Curve::bounds(double from, double to) const {
  return on_face_ ? map_.bounds(own_bounds(from, to), flat_bounds(from, to)) : own_bounds(from, to);
}

// Of lines and arcs: others do not lie on a face.
FlatBounds Curve::flat_bounds(double from, double to) const {
  const auto flat = [this](const AxisVector& v) { return map_.flat(v); };
  if (kind_ == Kind::line) return bounds_of_line(flat(c_[0]), flat(c_[1]), from, to);
  return bounds_of_arc(flat(c_[0]), {radius_, radius_slope_, angle_rad_, rate_}, from, to);
}

CurveBounds Curve::own_bounds(double from, double to) const {
  switch (kind_) {
    case Kind::line: {
      CurveBounds bounds;
      for (std::size_t m = 0; m < axes_; ++m) bounds.first.values[m] = std::fabs(c_[1].values[m]);
      return bounds;
    }
    case Kind::cubic: return polynomial_bounds<4>(from, to);
    case Kind::quintic: return polynomial_bounds<6>(from, to);
    case Kind::arc: break;
  }
  return arc_bounds(from, to);
}

double Curve::curvature_bound(double from, double to, const CurveBounds& bounds,
                              const LinearAxes& linear) const {
  if (is_line()) return 0;
  if (on_face_) return map_.bend(bounds, flat_bounds(from, to));
  if (kind_ == Kind::arc)
    return std::fabs(rate_) * math::hypot(2 * radius_slope_, rate_ * largest_radius(from, to));
  return AxisNorms{linear, axes_}.mm(bounds.second);
}

double Curve::largest_radius(double from, double to) const {
  return std::max(std::fabs(radius_ + radius_slope_ * from),
                  std::fabs(radius_ + radius_slope_ * to));
}

// Two halves: Bernstein's bound of a hat is then the hat itself. An axis that stands still has
// none.
template <std::size_t count>
CurveBounds Curve::polynomial_bounds(double from, double to) const {
  CurveBounds bounds;
  const double width = (to - from) / 2;
  for (std::size_t m = 0; m < axes_; ++m) {
    const auto c = coefficients<count>(m);
    if (std::all_of(c.begin() + 1, c.end(), [](double value) { return value == 0; })) continue;
    for (const double begin : {from, from + width}) {
      auto shifted = c;
      if (begin != 0) shift(shifted, begin);
      const auto first = derivative(shifted);
      const auto second = derivative(first);
      const auto third = derivative(second);
      const auto see = [](double& bound, double value) { bound = std::max(bound, value); };
      see(bounds.first.values[m], largest<kHighest - 1>(first, width));
      see(bounds.second.values[m], largest<kHighest - 2>(second, width));
      see(bounds.third.values[m], largest<kHighest - 3>(third, width));
    }
  }
  return bounds;
}

CurveBounds Curve::arc_bounds(double from, double to) const {
  CurveBounds bounds;
  const double r = largest_radius(from, to);
  const double w = std::fabs(rate_);
  const double grow = std::fabs(radius_slope_);
  const auto [low, high] = std::minmax({angle_rad_ + rate_ * from, angle_rad_ + rate_ * to});
  Sector sector{{low}, {high}};
  for (std::size_t m = 0; m < axes_; ++m) {
    const double out = largest_swing(c_[2].values[m], c_[3].values[m], sector);
    const double along = largest_swing(c_[3].values[m], -c_[2].values[m], sector);
    bounds.first.values[m] = std::fabs(c_[1].values[m]) + grow * out + r * w * along;
    bounds.second.values[m] = w * (2 * grow * along + r * w * out);
    bounds.third.values[m] = w * w * (3 * grow * out + r * w * along);
  }
  return bounds;
}

}  // namespace kerf::motion
