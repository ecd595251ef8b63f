#include "motion/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::motion {
namespace {

using base::TipJet;
using base::TipPoint;

constexpr std::size_t kMostCoefficients = 6;

/// Largest absolute value of a polynomial on [0, width], from its coefficients there in Bernstein's
/// form, which bound it; `count` <= kMostCoefficients. The bound is the value itself at both ends.
double largest(std::array<double, kMostCoefficients> c, std::size_t count, double width) {
  double power = 1;
  for (std::size_t k = 0; k < count; ++k, power *= width) c[k] *= power;
  // Monomial to Bernstein: b_i = Σ_k C(i,k) / C(n,k) c_k, n = count - 1.
  double most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double factor = 1;
    double b = c[0];
    for (std::size_t k = 1; k <= i; ++k) {
      factor *= static_cast<double>(i - k + 1) / static_cast<double>(count - k);
      b += factor * c[k];
    }
    most = std::max(most, std::fabs(b));
  }
  return most;
}

/// The same polynomial with its origin at `at`.
void shift(std::array<double, kMostCoefficients>& c, std::size_t count, double at) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    for (std::size_t k = count - 1; k-- > i;) c[k] += at * c[k + 1];
  }
}

void differentiate(std::array<double, kMostCoefficients>& c, std::size_t& count) {
  for (std::size_t k = 1; k < count; ++k) c[k - 1] = static_cast<double>(k) * c[k];
  --count;
}

/// Largest |a cos φ + b sin φ| for φ in [from, to].
double largest_swing(double a, double b, double from, double to) {
  const double amplitude = math::hypot(a, b);
  if (to - from >= std::numbers::pi) return amplitude;
  const double peak = math::atan2(b, a);
  const double first = std::ceil((from - peak) / std::numbers::pi);
  if (peak + first * std::numbers::pi <= to) return amplitude;
  return std::max(std::fabs(a * math::cos(from) + b * math::sin(from)),
                  std::fabs(a * math::cos(to) + b * math::sin(to)));
}

}  // namespace

Curve Curve::line(const TipPoint& from, const TipPoint& to, double length, std::size_t axes) {
  Curve curve;
  curve.length_ = length;
  curve.end_ = to;
  curve.axes_ = static_cast<std::uint8_t>(axes);
  curve.c_[0] = from;
  for (std::size_t m = 0; m < axes; ++m)
    curve.c_[1].values[m] = (to.values[m] - from.values[m]) / length;
  return curve;
}

Curve Curve::hermite(const TipJet& from, const TipJet& to, double length, std::size_t axes) {
  Curve curve;
  curve.kind_ = Kind::polynomial;
  curve.length_ = length;
  curve.end_ = to.value;
  curve.axes_ = static_cast<std::uint8_t>(axes);
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
  Curve curve;
  curve.kind_ = Kind::polynomial;
  curve.length_ = length;
  curve.end_ = to.value;
  curve.axes_ = static_cast<std::uint8_t>(axes);
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
  Curve curve;
  curve.kind_ = Kind::arc;
  curve.length_ = length;
  curve.end_ = to;
  curve.axes_ = static_cast<std::uint8_t>(axes);
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

double Curve::length_at_first_radius() const {
  return kind_ == Kind::arc ? radius_ * std::fabs(rate_) * length_ : length_;
}

TipPoint Curve::at(double s) const { return s >= length_ ? end_ : point(s); }

TipPoint Curve::point(double s) const {
  TipPoint p;
  switch (kind_) {
    case Kind::line:
      for (std::size_t m = 0; m < axes_; ++m) p.values[m] = c_[0].values[m] + s * c_[1].values[m];
      break;
    case Kind::polynomial:
      for (std::size_t m = 0; m < axes_; ++m) {
        double value = c_[5].values[m];
        for (std::size_t k = 5; k-- > 0;) value = c_[k].values[m] + s * value;
        p.values[m] = value;
      }
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

TipJet Curve::jet(double s) const {
  TipJet jet;
  switch (kind_) {
    case Kind::line:
      jet.value = point(s);
      jet.first = c_[1];
      break;
    case Kind::polynomial: jet = polynomial_jet(s); break;
    case Kind::arc: jet = arc_jet(s); break;
  }
  if (s >= length_) jet.value = end_;
  return jet;
}

TipJet Curve::polynomial_jet(double s) const {
  TipJet jet;
  for (std::size_t m = 0; m < axes_; ++m) {
    double value = c_[5].values[m];
    double first = 0;
    double second = 0;
    double third = 0;
    for (std::size_t k = 5; k-- > 0;) {
      third = second + s * third;
      second = first + s * second;
      first = value + s * first;
      value = c_[k].values[m] + s * value;
    }
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
  switch (kind_) {
    case Kind::line: {
      CurveBounds bounds;
      for (std::size_t m = 0; m < axes_; ++m) bounds.first.values[m] = std::fabs(c_[1].values[m]);
      return bounds;
    }
    case Kind::polynomial: return polynomial_bounds(from, to);
    case Kind::arc: break;
  }
  return arc_bounds(from, to);
}

double Curve::curvature_bound(double from, double to, const CurveBounds& bounds,
                              const LinearAxes& linear) const {
  if (kind_ == Kind::line) return 0;
  if (kind_ == Kind::arc)
    return std::fabs(rate_) * math::hypot(2 * radius_slope_, rate_ * largest_radius(from, to));
  return AxisNorms{linear, axes_}.mm(bounds.second);
}

double Curve::largest_radius(double from, double to) const {
  return std::max(std::fabs(radius_ + radius_slope_ * from),
                  std::fabs(radius_ + radius_slope_ * to));
}

// Two halves: Bernstein's bound of a hat is then the hat itself.
CurveBounds Curve::polynomial_bounds(double from, double to) const {
  CurveBounds bounds;
  const double width = (to - from) / 2;
  for (std::size_t m = 0; m < axes_; ++m) {
    for (const double begin : {from, from + width}) {
      std::array<double, kMostCoefficients> c;
      for (std::size_t k = 0; k < kMostCoefficients; ++k) c[k] = c_[k].values[m];
      std::size_t count = kMostCoefficients;
      shift(c, count, begin);
      for (double* const bound :
           {&bounds.first.values[m], &bounds.second.values[m], &bounds.third.values[m]}) {
        differentiate(c, count);
        *bound = std::max(*bound, largest(c, count, width));
      }
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
  for (std::size_t m = 0; m < axes_; ++m) {
    const double out = largest_swing(c_[2].values[m], c_[3].values[m], low, high);
    const double along = largest_swing(c_[3].values[m], -c_[2].values[m], low, high);
    bounds.first.values[m] = std::fabs(c_[1].values[m]) + grow * out + r * w * along;
    bounds.second.values[m] = w * (2 * grow * along + r * w * out);
    bounds.third.values[m] = w * w * (3 * grow * out + r * w * along);
  }
  return bounds;
}

}  // namespace kerf::motion
