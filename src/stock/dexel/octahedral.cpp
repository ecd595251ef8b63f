#include "stock/dexel/octahedral.hpp"

#include <cmath>

namespace kerf::stock::dexel {
namespace {

constexpr double kSteps = 127;

/// Rounded to the nearest, of two the even one: what the last place of this sum is.
double rounded(double value) {
  constexpr double kUnits = 0x1.8p52;
  return (value + kUnits) - kUnits;
}

std::int8_t packed(double value) { return static_cast<std::int8_t>(rounded(value * kSteps)); }

/// The lower half of the octahedron lies outside of the diamond that the upper one fills.
double folded(double value, double other) { return std::copysign(1 - std::fabs(other), value); }

}  // namespace

Octahedral octahedral(geometry::Vec3 d) {
  const double scale = 1 / (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
  const double x = d.x * scale;
  const double y = d.y * scale;
  if (d.z >= 0) return {packed(x), packed(y)};
  return {packed(folded(x, y)), packed(folded(y, x))};
}

geometry::Vec3 direction(Octahedral p) {
  const double x = p[0] / kSteps;
  const double y = p[1] / kSteps;
  const double z = 1 - std::fabs(x) - std::fabs(y);
  const geometry::Vec3 d =
      z >= 0 ? geometry::Vec3{x, y, z} : geometry::Vec3{folded(x, y), folded(y, x), z};
  return (1 / std::sqrt(dot(d, d))) * d;
}

}  // namespace kerf::stock::dexel
