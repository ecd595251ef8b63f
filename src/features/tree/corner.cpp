#include "features/tree/corner.hpp"

#include <cmath>

namespace kerf::features {
namespace {

using contour::Edge;
using contour::Vec2;

constexpr double kSmooth = 1e-3;    // sine of the angle at which an arc goes over into a line
constexpr double kParallel = 1e-4;  // of lines that meet nowhere near

bool is_smooth(Vec2 a, Vec2 b) {
  return std::fabs(geometry::cross(geometry::unit(a), geometry::unit(b))) < kSmooth &&
         geometry::dot(a, b) > 0;
}

}  // namespace

std::optional<Vec2> corner_of(const Edge& before, const Edge& arc, const Edge& behind) {
  if (before.bulge != 0 || behind.bulge != 0) return std::nullopt;
  const Vec2 in = contour::tangent_at_start(arc);
  const Vec2 out = contour::tangent_at_end(arc);
  if (!is_smooth(before.to - before.from, in) || !is_smooth(out, behind.to - behind.from))
    return std::nullopt;
  const Vec2 u = geometry::unit(before.to - before.from);
  const Vec2 v = geometry::unit(behind.to - behind.from);
  const double sine = geometry::cross(u, v);
  if (std::fabs(sine) < kParallel || std::fabs(arc.bulge) >= 1) return std::nullopt;
  const double along = geometry::cross(behind.from - before.to, v) / sine;
  return before.to + along * u;
}

}  // namespace kerf::features
