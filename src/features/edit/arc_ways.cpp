#include "features/edit/arc_ways.hpp"

#include <cmath>

#include "features/path/tolerance.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::features {

using contour::Edge;
using contour::Vec2;

std::optional<Edge> arc_through(Vec2 first, Vec2 second, Vec2 third) {
  constexpr double kFlattest = 1e-9;  // bulge: rounding on a line
  const Vec2 in = second - first;
  const Vec2 out = third - second;
  // The turn from one chord to the next is half of the swept angle.
  const double across = cross(in, out);
  const double whole = geometry::length(in) * geometry::length(out) + dot(in, out);
  const double bulge = across / whole;
  if (!std::isfinite(bulge) || std::fabs(bulge) < kFlattest) return std::nullopt;
  if (geometry::length(third - first) <= kSamePoint_mm) return std::nullopt;
  return Edge{first, third, bulge};
}

std::optional<Edge> arc_about(Vec2 centre, double radius, double start_deg, double end_deg,
                              bool is_clockwise) {
  const double sense = is_clockwise ? -1 : 1;
  double sweep_deg = std::fmod(sense * (end_deg - start_deg), 360);
  if (sweep_deg < 0) sweep_deg += 360;
  const auto on_circle = [&](double angle_deg) {
    const auto [sine, cosine] = geometry::sine_cosine_deg(angle_deg);
    return centre + radius * Vec2{cosine, sine};
  };
  const Edge arc{on_circle(start_deg), on_circle(end_deg),
                 sense * math::tan(geometry::radians(sweep_deg) / 4)};
  if (!(geometry::length(arc.to - arc.from) > kSamePoint_mm)) return std::nullopt;
  return arc;
}

std::optional<Edge> with_radius(const Edge& arc, double radius) {
  const double half_mm = geometry::length(arc.to - arc.from) / 2;
  if (radius < half_mm - kSamePoint_mm / 2) return std::nullopt;
  const double height_mm = std::sqrt(std::max(0.0, radius * radius - half_mm * half_mm));
  const double short_way = half_mm / (std::max(radius, half_mm) + height_mm);
  const double bulge = std::fabs(arc.bulge) > 1 ? 1 / short_way : short_way;
  return Edge{arc.from, arc.to, std::copysign(bulge, arc.bulge), arc.owner};
}

}  // namespace kerf::features
