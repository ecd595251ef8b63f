#include "stock/surface/internal/quadric.hpp"

#include <cmath>

namespace kerf::stock::surface {
namespace {

using geometry::Vec3;

/// A determinant below this share of the largest there could be: an edge, or a plane.
constexpr double kFlat = 1e-4;

}  // namespace

Quadric::Quadric(Vec3 n, Vec3 place, double weight) {
  const double d = -dot(n, place);
  a_ = {n.x * n.x, n.x * n.y, n.x * n.z, n.x * d, n.y * n.y,
        n.y * n.z, n.y * d,   n.z * n.z, n.z * d, d * d};
  for (double& each : a_) each *= weight;
}

Quadric& Quadric::operator+=(const Quadric& other) {
  for (std::size_t i = 0; i < a_.size(); ++i) a_[i] += other.a_[i];
  return *this;
}

double Quadric::at(Vec3 p) const {
  return a_[0] * p.x * p.x + a_[4] * p.y * p.y + a_[7] * p.z * p.z +
         2 * (a_[1] * p.x * p.y + a_[2] * p.x * p.z + a_[5] * p.y * p.z) +
         2 * (a_[3] * p.x + a_[6] * p.y + a_[8] * p.z) + a_[9];
}

// Cramer's rule by cross products of the symmetric matrix's rows.
std::optional<Vec3> Quadric::least() const {
  const Vec3 x{a_[0], a_[1], a_[2]};
  const Vec3 y{a_[1], a_[4], a_[5]};
  const Vec3 z{a_[2], a_[5], a_[7]};
  const Vec3 right{-a_[3], -a_[6], -a_[8]};
  const double determinant = dot(x, cross(y, z));
  const double trace = a_[0] + a_[4] + a_[7];
  if (!(determinant > kFlat * trace * trace * trace / 27)) return std::nullopt;
  const Vec3 sum = right.x * cross(y, z) + right.y * cross(z, x) + right.z * cross(x, y);
  return (1 / determinant) * sum;
}

}  // namespace kerf::stock::surface
