#include "motion/path_speed.hpp"

#include <algorithm>
#include <array>

#include "motion/spindle_speed.hpp"

namespace kerf::motion {
namespace {

// A lead that shrinks to nothing, mm/s: it keeps times finite.
constexpr double kSlowest = 1e-3;
// Near there no part is shorter.
constexpr double kShortest_mm = 1e-4;
// A part that would leave less than another one behind it is cut in two equal ones.
constexpr double kTwoParts = 2;
// What rounding makes of a bound.
constexpr double kSame = 1 + 1e-9;

// Gauss's rule with three places, on [-1, 1].
constexpr std::array<double, 3> kGaussPlaces{-0.774596669241483377, 0, 0.774596669241483377};
constexpr std::array<double, 3> kGaussWeights{5.0 / 18, 8.0 / 18, 5.0 / 18};

/// ∫ max(|x|, least) dx from 0.
double integral(double x, double least) {
  const double size = std::fabs(x);
  const double sum = size <= least ? size * least : (size * size + least * least) / 2;
  return std::copysign(sum, x);
}

/// Mean of max(|x|, least) between two places. Without differences of near numbers where both are
/// on one side.
double mean_radius(double a, double b, double least) {
  const double smaller = std::min(std::fabs(a), std::fabs(b));
  if (std::max(std::fabs(a), std::fabs(b)) <= least) return least;
  if (smaller >= least && std::signbit(a) == std::signbit(b)) return std::fabs(a + b) / 2;
  if (std::fabs(b - a) < 1e-9 * least) return std::max(std::fabs(a + b) / 2, least);
  return (integral(b, least) - integral(a, least)) / (b - a);
}

}  // namespace

PathSpeed PathSpeed::constant(double speed) {
  PathSpeed result;
  result.value_ = speed;
  return result;
}

PathSpeed PathSpeed::surface(const Spindle& spindle, double feed) {
  PathSpeed result;
  result.kind_ = Kind::surface;
  result.axis_ = spindle.radius_axis.value_or(base::Axis{});
  result.centre_ = spindle.centre;
  result.value_ = feed * radius_speed(spindle) / 60;
  result.least_radius_ = radius_of_limit(spindle);
  return result;
}

PathSpeed PathSpeed::growing(double speed, double rate) {
  PathSpeed result;
  result.kind_ = Kind::growing;
  result.value_ = speed;
  result.centre_ = rate;
  return result;
}

PathSpeed PathSpeed::slower(const PathSpeed& a, double here_a, const PathSpeed& b, double here_b) {
  const PathSpeed& chosen = here_b < here_a ? b : a;
  if (a.kind_ == b.kind_ && chosen.kind_ != Kind::growing) return chosen;
  return constant(std::min(here_a, here_b));
}

double PathSpeed::radius_at(const Curve& curve, double s) const {
  return curve.at(s)[axis_] - centre_;
}

double PathSpeed::effective_radius(const Curve& curve, double s) const {
  return std::max(std::fabs(radius_at(curve, s)), least_radius_);
}

double PathSpeed::growing_at(double s) const {
  return std::sqrt(std::max(value_ * value_ + 2 * centre_ * s, kSlowest * kSlowest));
}

double PathSpeed::changing_at(const Curve& curve, double s) const {
  return kind_ == Kind::growing ? growing_at(s) : value_ / effective_radius(curve, s);
}

double PathSpeed::seconds(const Curve& curve, double from, double to) const {
  switch (kind_) {
    case Kind::constant: return (to - from) / value_;
    case Kind::growing: return 2 * (to - from) / (growing_at(from) + growing_at(to));
    case Kind::surface: break;
  }
  if (curve.is_line()) return seconds_of_line(curve, from, to);
  double sum = 0;
  for (double begin = from; begin < to;) {
    const double end = part_end(curve, begin, to);
    sum += seconds_of_part(curve, begin, end);
    begin = end;
  }
  return sum;
}

double PathSpeed::seconds_of_line(const Curve& line, double from, double to) const {
  const double radius = mean_radius(radius_at(line, from), radius_at(line, to), least_radius_);
  return (to - from) * radius / value_;
}

double PathSpeed::seconds_of_part(const Curve& curve, double from, double to) const {
  const double half = (to - from) / 2;
  double radius = 0;
  for (std::size_t i = 0; i < kGaussPlaces.size(); ++i)
    radius += kGaussWeights[i] * effective_radius(curve, from + half * (1 + kGaussPlaces[i]));
  return (to - from) * radius / value_;
}

double PathSpeed::part_end(const Curve& curve, double from, double to) const {
  if (kind_ == Kind::constant) return to;
  const double end =
      kind_ == Kind::surface ? surface_part(curve, from, to) : growing_part(from, to);
  const bool cuts_off_little = end < to && to - from < kTwoParts * (end - from);
  return cuts_off_little ? from + (to - from) / 2 : end;
}

// The radius changes by |dx/ds| at most. Nearer to the axis than the limit of the spindle allows it
// does not matter how it does, up to where the limit ends.
double PathSpeed::surface_part(const Curve& curve, double from, double to) const {
  const double radius = std::fabs(radius_at(curve, from));
  const double most =
      std::max(kStep * std::max(radius, least_radius_), least_radius_ - radius) * kSame;
  for (double width = to - from;;) {
    const double slope = curve.bounds(from, from + width).first[axis_];
    if (slope * width <= most * kSame) return width < to - from ? from + width : to;
    width = curve.is_line() ? most / slope : std::max(width / 2, most / slope);
  }
}

double PathSpeed::growing_part(double from, double to) const {
  const double square = growing_at(from) * growing_at(from);
  if (centre_ == 0) return to;
  const double side = centre_ > 0 ? 1 + kStep : 1 - kStep;
  const double width = square * (side * side - 1) / (2 * centre_);
  return std::min(to, from + std::max(width, kShortest_mm));
}

double mean_rpm(const Spindle& spindle, std::span<const Curve> curves) {
  const PathSpeed speed = PathSpeed::surface(spindle, 1);
  double length = 0;
  double seconds = 0;
  for (const Curve& curve : curves) {
    length += curve.length();
    seconds += speed.seconds(curve, 0, curve.length());
  }
  return length / seconds * 60;
}

PathSpeed PathSpeed::over(double units) const {
  PathSpeed result = *this;
  result.value_ /= units;
  if (kind_ == Kind::growing) result.centre_ /= units * units;
  return result;
}

PathSpeed PathSpeed::times(double factor) const {
  PathSpeed result = *this;
  result.value_ *= factor;
  if (kind_ == Kind::growing) result.centre_ *= factor * factor;
  return result;
}

}  // namespace kerf::motion
