#include "geometry/angled_line.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::geometry {
namespace {

Vec2 direction_of(const AngledLine& line) {
  const SineCosine turn = sine_cosine_deg(line.angle_deg);
  return {turn.cosine, turn.sine};
}

}  // namespace

std::optional<Vec2> point_at_u(const AngledLine& line, double u) {
  const Vec2 d = direction_of(line);
  if (std::fabs(d.u) < kParallel_rad) return std::nullopt;
  return Vec2{u, line.through.v + (u - line.through.u) / d.u * d.v};
}

std::optional<Vec2> point_at_v(const AngledLine& line, double v) {
  const Vec2 d = direction_of(line);
  if (std::fabs(d.v) < kParallel_rad) return std::nullopt;
  return Vec2{line.through.u + (v - line.through.v) / d.v * d.u, v};
}

std::optional<Vec2> crossing(const AngledLine& a, const AngledLine& b) {
  const Vec2 d1 = direction_of(a);
  const Vec2 d2 = direction_of(b);
  const double sine = cross(d1, d2);
  if (std::fabs(sine) < kParallel_rad) return std::nullopt;
  return a.through + (cross(b.through - a.through, d2) / sine) * d1;
}

double distance(const AngledLine& line, Vec2 point) {
  return std::fabs(cross(direction_of(line), point - line.through));
}

}  // namespace kerf::geometry
