#include "stock/turned/ball_touch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/contour/contour.hpp"
#include "math/math.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Edge;
using geometry::Vec2;

constexpr double kNone_mm = 1e-9;
// Who stands on the axis stands beside it: there the region has a border, and the part none.
constexpr double kBesideAxis_mm = 1e-7;
// It goes on by at least this before it is looked at again: over an edge that is cut by less than
// the square of it over eight radii it slides.
constexpr double kStep_mm = 0.01;
// A ball that touches already and comes nearer by less than this slides along.
constexpr double kSlip_mm = 1e-6;
constexpr int kHalvings = 50;

/// All borders but the axis, which is none.
std::vector<Edge> surface_of(const contour::Region& region) {
  std::vector<Edge> edges;
  for (const contour::Contour& loop : region.loops) {
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
      const Edge edge = contour::edge_of(loop, i);
      if (edge.bulge != 0 || edge.from.v > kNone_mm || edge.to.v > kNone_mm) edges.push_back(edge);
    }
  }
  return edges;
}

/// The disc on its way: where the nearest of the surface is.
class Gap {
 public:
  Gap(const contour::Region& region, const BallWay& ball)
      : region_(region), surface_(surface_of(region)), ball_(ball) {}

  /// mm between ball and material; less than 0: they overlap.
  [[nodiscard]] double at(double t) const {
    const Vec2 middle = centre(t);
    double least = HUGE_VAL;
    for (const Edge& edge : surface_) least = std::min(least, contour::distance(edge, middle));
    const bool is_inside = contour::side_of(region_, middle, 0) == contour::Side::inside;
    return (is_inside ? -least : least) - ball_.radius_mm;
  }

 private:
  [[nodiscard]] Vec2 centre(double t) const {
    const Vec3 p = point_at(ball_.way, t);
    return {p.z, std::max(kBesideAxis_mm, math::hypot(p.x, p.y))};
  }

  const contour::Region& region_;
  std::vector<Edge> surface_;
  BallWay ball_;
};

/// Between a t at which they do not touch and one at which they do.
double touch_between(const Gap& gap, double free, double met) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (free + met) / 2;
    (gap.at(middle) > 0 ? free : met) = middle;
  }
  return met;
}

}  // namespace

// The gap never closes faster than the ball goes: so far it may go without asking.
std::optional<double> first_touch(const contour::Region& region, const BallWay& ball) {
  const Gap gap(region, ball);
  const double length = stock::length(Way(ball.way));
  double before = gap.at(0);
  if (before < -kLeft_mm) return 0.0;
  for (double t = 0; t < 1 && length > 0;) {
    const double next = std::min(1.0, t + std::max(before, kStep_mm) / length);
    const double now = gap.at(next);
    const bool touches = before <= kNone_mm;
    if (touches && now < before - kSlip_mm) return t;
    if (!touches && now <= 0) return touch_between(gap, t, next);
    t = next;
    before = now;
  }
  return std::nullopt;
}

}  // namespace kerf::stock::turned
