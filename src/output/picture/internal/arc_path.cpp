#include "output/picture/internal/arc_path.hpp"

#include <cmath>

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;
constexpr double kTurn = 4 * kQuarterTurn;

struct PlaneAxes {
  std::size_t first, second, normal;
};

PlaneAxes axes_of(motion::Plane plane) {
  switch (plane) {
    case motion::Plane::xy: return {kX, kY, kZ};
    case motion::Plane::zx: return {kZ, kX, kY};
    case motion::Plane::yz: return {kY, kZ, kX};
  }
  return {kX, kY, kZ};
}

// From angle to angle in the given direction, without extra turns; never zero.
double sweep_between(double start_rad, double end_rad, motion::Direction direction) {
  const bool ccw = direction == motion::Direction::counterclockwise;
  double sweep = ccw ? end_rad - start_rad : start_rad - end_rad;
  if (sweep <= 0) sweep += kTurn;
  return ccw ? sweep : -sweep;
}

}  // namespace

ArcPath::ArcPath(const Point3& from, const motion::Arc& arc, const Point3& to,
                 const std::array<double, 2>& center)
    : from_(from), to_(to), center_(center) {
  const PlaneAxes axes = axes_of(arc.plane);
  first_ = axes.first;
  second_ = axes.second;
  normal_ = axes.normal;
  const double u0 = from[first_] - center[0], v0 = from[second_] - center[1];
  const double u1 = to[first_] - center[0], v1 = to[second_] - center[1];
  angle_rad_ = math::atan2(v0, u0);
  sweep_rad_ = sweep_between(angle_rad_, math::atan2(v1, u1), arc.direction);
  const double extra = kTurn * std::min<int>(arc.turns, kMaxTurns);
  sweep_rad_ += sweep_rad_ > 0 ? extra : -extra;
  radius_ = std::sqrt(u0 * u0 + v0 * v0);
  radius_growth_ = std::sqrt(u1 * u1 + v1 * v1) - radius_;
}

Point3 ArcPath::at(double t) const {
  if (t <= 0) return from_;
  if (t >= 1) return to_;
  const double angle = angle_rad_ + sweep_rad_ * t;
  const double radius = radius_ + radius_growth_ * t;
  Point3 point;
  const auto [sine, cosine] = math::sine_cosine(angle);
  point[first_] = center_[0] + radius * cosine;
  point[second_] = center_[1] + radius * sine;
  point[normal_] = from_[normal_] + (to_[normal_] - from_[normal_]) * t;
  return point;
}

Point3 ArcPath::derivative(double t) const {
  const double angle = angle_rad_ + sweep_rad_ * t;
  const double around = (radius_ + radius_growth_ * t) * sweep_rad_;
  const auto [sine, cosine] = math::sine_cosine(angle);
  Point3 slope;
  slope[first_] = radius_growth_ * cosine - around * sine;
  slope[second_] = radius_growth_ * sine + around * cosine;
  slope[normal_] = to_[normal_] - from_[normal_];
  return slope;
}

// An axis' extreme lies at an end or where the angle is a whole number of quarter turns. The radius
// changes one way, so the first and the last turn hold the extremes.
void ArcPath::extend(Box3& box) const {
  box.add(from_);
  box.add(to_);
  const double a = angle_rad_, b = angle_rad_ + sweep_rad_;
  const auto first = static_cast<int>(std::ceil(std::min(a, b) / kQuarterTurn));
  const auto last = static_cast<int>(std::floor(std::max(a, b) / kQuarterTurn));
  for (int quarter = first; quarter <= last; ++quarter) {
    if (quarter == first + 4) quarter = std::max(quarter, last - 3);
    box.add(at((quarter * kQuarterTurn - angle_rad_) / sweep_rad_));
  }
}

std::size_t ArcPath::span_count() const {
  const double quarters = std::abs(sweep_rad_) / kQuarterTurn;
  return static_cast<std::size_t>(std::max(1.0, std::ceil(quarters - 1e-9)));
}

Bezier ArcPath::span(std::size_t number) const {
  const auto count = static_cast<double>(span_count());
  const double t0 = static_cast<double>(number) / count;
  const double t1 = static_cast<double>(number + 1) / count;
  const double angle = std::abs(sweep_rad_) / count;
  // Handles of the usual circle approximation, scaled from the derivative by the parameter.
  const double reach = 4.0 / 3.0 * math::tan(angle / 4) / angle * (t1 - t0);
  Bezier curve{at(t0), at(t1), at(t1)};
  const Point3 leave = derivative(t0), arrive = derivative(t1);
  for (std::size_t i = 0; i < 3; ++i) {
    curve.control1[i] += leave[i] * reach;
    curve.control2[i] -= arrive[i] * reach;
  }
  return curve;
}

// The sagitta of a chord over the angle a is r (1 - cos(a/2)), about r a^2 / 8.
std::size_t ArcPath::chord_count(double tolerance) const {
  const double radius = std::max(radius_, radius_ + radius_growth_);
  const double finest = kTurn / 3600, coarsest = kTurn / 6;
  const double angle = std::clamp(std::sqrt(8 * tolerance / radius), finest, coarsest);
  return static_cast<std::size_t>(std::ceil(std::abs(sweep_rad_) / angle));
}

}  // namespace kerf::output::plot
