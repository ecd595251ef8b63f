#include "stock/tool/internal/outline.hpp"

#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

ProfilePoint turned(ProfilePoint point, ProfilePoint centre, double angle_rad) {
  const auto [sine, cosine] = math::sine_cosine(angle_rad);
  const double r = point.r - centre.r;
  const double z = point.z - centre.z;
  return {centre.r + r * cosine - z * sine, centre.z + r * sine + z * cosine};
}

}  // namespace

void Outline::to(ProfilePoint point, ToolPart part, double bulge) {
  if (point == at()) return;
  edges_.push_back({at(), point, bulge, part});
}

void Outline::arc_to(ProfilePoint point, ProfilePoint centre, double sweep_rad, ToolPart part) {
  // A quarter that rounding has made a little larger is one piece.
  const bool halved = std::abs(sweep_rad) > std::numbers::pi / 2 + 1e-12;
  const double piece = halved ? sweep_rad / 2 : sweep_rad;
  const double bulge = math::tan(piece / 4);
  if (halved) to(turned(at(), centre, piece), part, bulge);
  to(point, part, bulge);
}

}  // namespace kerf::stock
