#include "programmed_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/arc.hpp"
#include "geometry/space_arc.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::TipPoint;
using geometry::Vec2;
using geometry::Vec3;

// More motions than a period passes.
constexpr std::size_t kFar = 400;

double distance_to_segment(const TipPoint& p, const AxisVector& a, const AxisVector& b) {
  double dot = 0;
  double square = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const double d = b.values[m] - a.values[m];
    dot += (p.values[m] - a.values[m]) * d;
    square += d * d;
  }
  const double t = square > 0 ? std::clamp(dot / square, 0.0, 1.0) : 0;
  double distance = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const double on = a.values[m] + t * (b.values[m] - a.values[m]);
    distance += (p.values[m] - on) * (p.values[m] - on);
  }
  return std::sqrt(distance);
}

/// A programmed arc as a function of the part of it that is behind, 0 to 1.
class ProgrammedArc {
 public:
  ProgrammedArc(const TipPoint& from, const motion::Arc& arc, const motion::AxisSetup& axes)
      : from_(from), arc_(arc), plane_(*motion::plane_axes(arc.plane, axes)) {
    const bool clockwise = arc.direction == motion::Direction::clockwise;
    const Vec2 start = plane_.project(from) - centre();
    sweep_ =
        geometry::sweep_rad(plane_.project(from), plane_.project(arc.to), centre(), clockwise) +
        2 * std::numbers::pi * arc.turns;
    if (clockwise) sweep_ = -sweep_;
    angle_ = std::atan2(start.v, start.u);
    radius_ = length(start);
    end_radius_ = length(plane_.project(arc.to) - centre());
  }

  [[nodiscard]] double distance(const TipPoint& p) const {
    const Vec2 here = plane_.project(p) - centre();
    double least = std::numeric_limits<double>::infinity();
    for (int turn = -2; turn <= 2; ++turn) {
      const double at = std::atan2(here.v, here.u) + turn * 2 * std::numbers::pi;
      least = std::min(least, distance_at(p, std::clamp((at - angle_) / sweep_, 0.0, 1.0)));
    }
    return least;
  }
  /// The same for steep helices, whose nearest point lies at another angle.
  [[nodiscard]] double searched_distance(const TipPoint& p) const {
    constexpr int kPlaces = 2000;
    int best = 0;
    for (int i = 1; i <= kPlaces; ++i) {
      if (distance_at(p, i * 1.0 / kPlaces) < distance_at(p, best * 1.0 / kPlaces)) best = i;
    }
    double low = std::max(0.0, (best - 1.0) / kPlaces);
    double high = std::min(1.0, (best + 1.0) / kPlaces);
    for (int i = 0; i < 60; ++i) {
      const double third = (high - low) / 3;
      const bool nearer_low = distance_at(p, low + third) < distance_at(p, high - third);
      (nearer_low ? high : low) += nearer_low ? -third : third;
    }
    return distance_at(p, low);
  }

 private:
  [[nodiscard]] Vec2 centre() const { return {arc_.center[0], arc_.center[1]}; }
  [[nodiscard]] double distance_at(const TipPoint& p, double part) const {
    const double radius = radius_ + (end_radius_ - radius_) * part;
    const double at = angle_ + part * sweep_;
    const Vec2 on{radius * std::cos(at), radius * std::sin(at)};
    const base::Axis normal = *plane_.normal;
    const double height = from_[normal] + part * (arc_.to[normal] - from_[normal]);
    return std::hypot(length(plane_.project(p) - centre() - on), p[normal] - height);
  }

  TipPoint from_;
  const motion::Arc& arc_;
  motion::PlaneAxes plane_;
  double sweep_ = 0;
  double angle_ = 0;
  double radius_ = 0;
  double end_radius_ = 0;
};

Vec3 place_of(const TipPoint& p) { return {p.values[0], p.values[1], p.values[2]}; }

double distance_to(const TipPoint& p, const TipPoint& from, const motion::SpaceArc& arc) {
  const auto circle =
      *geometry::SpaceArc::through(place_of(from), place_of(arc.via), place_of(arc.to));
  const Vec3 at = place_of(p) - circle.centre();
  const double angle = std::atan2(dot(at, circle.e2()), dot(at, circle.e1()));
  double least =
      std::min(length(place_of(p) - place_of(from)), length(place_of(p) - place_of(arc.to)));
  for (const double turned : {angle, angle + 2 * std::numbers::pi})
    least = std::min(least, length(place_of(p) - circle.at(turned)));
  return least;
}

}  // namespace

// The motion that the point says it belongs to and its neighbours first, by both ways: the others
// are many, and the search for the nearest place of a steep helix is slow.
bool ProgrammedPath::is_near(const TipPoint& tip, std::uint32_t line, double most_mm,
                             double& distance_mm) const {
  distance_mm = std::numeric_limits<double>::infinity();
  std::size_t begin = line;
  std::size_t end = line;
  for (const std::size_t around : {std::size_t{1}, kFar}) {
    const std::size_t first = line > around ? line - around : 1;
    const std::size_t last = std::min(path_.motions.size(), line + around);
    for (const Way way : {Way::quick, Way::searched}) {
      for (std::size_t n = first; n <= last; ++n) {
        if (around == kFar && n >= begin && n < end) continue;
        distance_mm = std::min(distance_mm, distance(tip, n, way));
        if (distance_mm <= most_mm) return true;
      }
    }
    begin = first;
    end = last + 1;
  }
  if (std::isinf(distance_mm)) distance_mm = 0;
  return distance_mm <= most_mm;
}

double ProgrammedPath::distance(const TipPoint& tip, std::size_t line, Way way) const {
  const motion::Motion& motion = path_.motions[line - 1];
  const auto* const rapid = std::get_if<motion::Rapid>(&motion.action);
  if (rapid != nullptr && !rapid->linear) return 0;  // only its end is promised
  const TipPoint* const to = motion::target_of(motion);
  if (to == nullptr) return std::numeric_limits<double>::infinity();
  const TipPoint from = start_of(line - 1);
  if (const auto* const arc = std::get_if<motion::Arc>(&motion.action)) {
    const ProgrammedArc programmed(from, *arc, path_.axes);
    return way == Way::quick ? programmed.distance(tip) : programmed.searched_distance(tip);
  }
  if (way == Way::searched) return std::numeric_limits<double>::infinity();
  if (const auto* const space_arc = std::get_if<motion::SpaceArc>(&motion.action))
    return distance_to(tip, from, *space_arc);
  return distance_to_segment(tip, from, *to);
}

TipPoint ProgrammedPath::start_of(std::size_t motion) const {
  while (motion-- > 0) {
    if (const TipPoint* const to = motion::target_of(path_.motions[motion])) return *to;
  }
  return path_.axes.start;
}

}  // namespace kerf::test
