#include "stock/surface/internal/nearest_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::stock::surface {
namespace {

constexpr double kBent = 0.03;  // of the largest eigenvalue: tan² of half of the angle
constexpr int kSweeps = 8;

using Matrix = std::array<std::array<double, 3>, 3>;

/// One rotation of Jacobi's method: makes a[p][q] 0.
void rotate(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1);
  const double s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = a[k][p];
    const double other = a[k][q];
    a[k][p] = c * one - s * other;
    a[k][q] = s * one + c * other;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = a[p][k];
    const double other = a[q][k];
    a[p][k] = c * one - s * other;
    a[q][k] = s * one + c * other;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double one = vectors[k][p];
    const double other = vectors[k][q];
    vectors[k][p] = c * one - s * other;
    vectors[k][q] = s * one + c * other;
  }
}

/// The smallest x with a x = b, as far as `a` speaks about it.
Vec3 solve(Matrix a, Vec3 b) {
  Matrix vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const double rest = std::fabs(a[0][1]) + std::fabs(a[0][2]) + std::fabs(a[1][2]);
    if (rest <= 1e-15 * (a[0][0] + a[1][1] + a[2][2])) break;
    rotate(a, vectors, 0, 1);
    rotate(a, vectors, 0, 2);
    rotate(a, vectors, 1, 2);
  }
  const double largest = std::max({a[0][0], a[1][1], a[2][2]});
  Vec3 x;
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i][i] <= kBent * largest) continue;
    const Vec3 v{vectors[0][i], vectors[1][i], vectors[2][i]};
    x = x + (dot(v, b) / a[i][i]) * v;
  }
  return x;
}

}  // namespace

void NearestPoint::add_plane(Vec3 place, Vec3 normal) {
  if (!has_origin_) origin_ = place;
  has_origin_ = true;
  normals_ = normals_ + normal;
  xx_ += normal.x * normal.x, xy_ += normal.x * normal.y, xz_ += normal.x * normal.z;
  yy_ += normal.y * normal.y, yz_ += normal.y * normal.z, zz_ += normal.z * normal.z;
  right_ = right_ + dot(normal, place - origin_) * normal;
}

Vec3 NearestPoint::find() const {
  const Vec3 middle = mean();
  if (!has_origin_) return middle;
  const Matrix a{{{xx_, xy_, xz_}, {xy_, yy_, yz_}, {xz_, yz_, zz_}}};
  const Vec3 from = middle - origin_;
  const Vec3 done{xx_ * from.x + xy_ * from.y + xz_ * from.z,
                  xy_ * from.x + yy_ * from.y + yz_ * from.z,
                  xz_ * from.x + yz_ * from.y + zz_ * from.z};
  return middle + solve(a, right_ - done);
}

}  // namespace kerf::stock::surface
