#include "drawing/svg/internal/endpoint_arc.hpp"

#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr double kPi = std::numbers::pi;

double angle_of(Vec2 v) { return math::atan2(v.v, v.u); }

}  // namespace

std::optional<CentreArc> by_centre(Vec2 from, Vec2 to, const EndpointArc& arc) {
  Vec2 radii{std::abs(arc.radii.u), std::abs(arc.radii.v)};
  if (!(radii.u > 0) || !(radii.v > 0)) return std::nullopt;
  const auto [sine, cosine] = math::sine_cosine(arc.turn_deg * kPi / 180);
  const Vec2 x{cosine, sine};
  const Vec2 y = geometry::left_of(x);
  // On the circle of radius 1 that the ellipse is in its own axes:
  const Vec2 half = 0.5 * (from - to);
  Vec2 unit_half{dot(half, x) / radii.u, dot(half, y) / radii.v};
  const double reach = dot(unit_half, unit_half);
  if (reach > 1) {
    radii = std::sqrt(reach) * radii;
    unit_half = (1 / std::sqrt(reach)) * unit_half;
  }
  const double height = reach >= 1 ? 0 : std::sqrt((1 - reach) / reach);
  const double side = arc.is_large == arc.is_sweep ? -1 : 1;
  const Vec2 unit_centre = -side * height * geometry::left_of(unit_half);
  const double begin = angle_of(unit_half - unit_centre);
  double sweep = angle_of(-unit_half - unit_centre) - begin;
  if (arc.is_sweep && sweep <= 0) sweep += 2 * kPi;
  if (!arc.is_sweep && sweep >= 0) sweep -= 2 * kPi;
  const Vec2 centre = 0.5 * (from + to) + radii.u * unit_centre.u * x + radii.v * unit_centre.v * y;
  return CentreArc{{centre, radii.u * x, radii.v * y}, begin, sweep};
}

}  // namespace kerf::drawing::svg
