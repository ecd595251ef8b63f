#include "process/wrapping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "kinematics/orientation.hpp"

namespace kerf::process {
namespace {

using base::TipPoint;
using contour::Edge;

constexpr double kMostChords = 1 << 20;

double angle_between_deg(Vec3 a, Vec3 b) {
  const double sine = geometry::length(geometry::cross(a, b));
  return math::atan2(sine, geometry::dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace

Wrapping::Wrapping(const Wrap& wrap, const motion::AxisSetup& axes, double tolerance_mm)
    : wrap_(wrap),
      surface_(wrap),
      tolerance_mm_(tolerance_mm),
      x_(*axes.find('X')),
      y_(*axes.find('Y')),
      z_(*axes.find('Z')),
      a_(*axes.find('A')),
      c_(*axes.find('C')) {}

Vec3 Wrapping::place(const TipPoint& tip) const { return {tip[x_], tip[y_], tip[z_]}; }

TipPoint Wrapping::tip(Vec2 at, double lift, const TipPoint& before) const {
  const SurfacePose pose = surface_.pose(at);
  const Vec3 place = pose.at + lift * pose.normal;
  TipPoint tip = before;
  tip[x_] = base::tidy(place.x);
  tip[y_] = base::tidy(place.y);
  tip[z_] = base::tidy(place.z);
  if (const auto angles = kinematics::orientation(pose.normal, {before[a_], before[c_]})) {
    tip[a_] = base::tidy(angles->a_deg);
    tip[c_] = base::tidy(angles->c_deg);
  }
  return tip;
}

std::vector<TipPoint> Wrapping::chords(const Edge& edge, double lift, double count,
                                       const TipPoint& before) const {
  std::vector<TipPoint> points;
  TipPoint last = before;
  for (double i = 1; i <= count; ++i) {
    const Vec2 at = i < count ? point_at(edge, i / count) : edge.to;
    points.push_back(last = tip(at, lift, last));
  }
  return points;
}

/// In the middle of each chord, where focus and beam are farthest from where they should be.
bool Wrapping::are_near(const Edge& edge, double lift, double count, double most_mm,
                        const TipPoint& before) const {
  TipPoint from = tip(edge.from, lift, before);
  double share = 0.5;
  for (const TipPoint& to : chords(edge, lift, count, from)) {
    const Vec3 middle = 0.5 * (place(from) + place(to));
    const kinematics::HeadAngles angles{0.5 * (from[a_] + to[a_]), 0.5 * (from[c_] + to[c_])};
    const Vec3 normal = surface_.pose(point_at(edge, share / count)).normal;
    const bool is_near = std::abs(surface_.distance(middle) - lift) <= most_mm;
    const bool is_square =
        lift > 0 || angle_between_deg(beam_axis(angles), normal) <= wrap_.normal_deg;
    if (!is_near || !is_square) return false;
    from = to;
    ++share;
  }
  return true;
}

/// The least that is enough: doubled until it is, then by halves between.
double Wrapping::chord_count(const Edge& edge, double lift, double most_mm,
                             const TipPoint& before) const {
  double enough = 1;
  while (enough < kMostChords && !are_near(edge, lift, enough, most_mm, before)) enough *= 2;
  double too_few = std::floor(enough / 2);
  while (enough - too_few > 1) {
    const double middle = std::floor(0.5 * (enough + too_few));
    (are_near(edge, lift, middle, most_mm, before) ? enough : too_few) = middle;
  }
  return enough;
}

std::vector<WrappedTarget> Wrapping::cut(const Edge& edge, const TipPoint& before) const {
  std::vector<WrappedTarget> targets;
  if (surface_.stays_straight(edge)) return {{tip(edge.to, 0, before), std::nullopt}};
  if (!surface_.goes_round(edge)) {
    for (const TipPoint& to : chords(edge, 0, chord_count(edge, 0, tolerance_mm_, before), before))
      targets.push_back({to, std::nullopt});
    return targets;
  }
  constexpr double kMostOfATurn = std::numbers::pi / 2;
  const double parts = std::max(1.0, std::ceil(surface_.turn_rad(edge) / kMostOfATurn - 1e-9));
  TipPoint last = before;
  for (double i = 0; i < parts; ++i) {
    const TipPoint via = tip(point_at(edge, (i + 0.5) / parts), 0, last);
    const Vec2 end = i + 1 < parts ? point_at(edge, (i + 1) / parts) : edge.to;
    targets.push_back({last = tip(end, 0, via), via});
  }
  return targets;
}

std::vector<TipPoint> Wrapping::travel(Vec2 from, Vec2 to, const TipPoint& before) const {
  const double lift = wrap_.clearance;
  std::vector<TipPoint> points{tip(from, lift, before)};
  if (to != from) {
    const Edge over{from, to};
    const double count = chord_count(over, lift, 0.5 * lift, points.back());
    for (const TipPoint& point : chords(over, lift, count, points.back())) points.push_back(point);
  }
  points.push_back(tip(to, 0, points.back()));
  return points;
}

}  // namespace kerf::process
