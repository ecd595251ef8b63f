#include "output/picture/solid/internal/corner_normals.hpp"

#include <cmath>

namespace kerf::output::plot {
namespace {

using geometry::Vec3;

constexpr double kSmooth = 0.82;  // cosine of 35 degrees

Vec3 vec(const std::array<float, 3>& v) { return {double{v[0]}, double{v[1]}, double{v[2]}}; }

}  // namespace

CornerNormals::CornerNormals(const mesh::TriangleMesh& mesh) : mesh_(mesh) {
  first_.assign(mesh.points.size() + 1, 0);
  for (const mesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) ++first_[corner + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  around_.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  faces_.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const mesh::Triangle& t = mesh.triangles[i];
    for (const std::uint32_t corner : t) around_[next[corner]++] = static_cast<std::uint32_t>(i);
    const Vec3 a = mesh.points[t[0]];
    const Vec3 n = cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
    faces_.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
}

std::array<Vec3, 3> CornerNormals::of(std::size_t triangle) const {
  const Vec3 own = vec(faces_[triangle]);
  const double own_size = std::sqrt(dot(own, own));
  std::array<Vec3, 3> normals;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t corner = mesh_.triangles[triangle][k];
    Vec3 sum;
    for (std::uint32_t i = first_[corner]; i < first_[corner + 1]; ++i) {
      const Vec3 face = vec(faces_[around_[i]]);
      const double size = std::sqrt(dot(face, face));
      if (dot(face, own) >= kSmooth * size * own_size) sum = sum + face;
    }
    const double size = std::sqrt(dot(sum, sum));
    normals[k] = size > 0 ? (1 / size) * sum : Vec3{0, 0, 1};
  }
  return normals;
}

}  // namespace kerf::output::plot
