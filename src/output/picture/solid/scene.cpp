#include "output/picture/solid/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::output::plot {
namespace {

struct Seen {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  double low = left;
  double high = -left;

  [[nodiscard]] bool is_empty() const { return left > right; }
};

Seen seen(const Scene& scene, const Camera& camera) {
  Seen all;
  for (const Body& body : scene.bodies) {
    for (const Vec3& p : body.mesh->points) {
      const double x = dot(camera.right, p);
      const double y = dot(camera.up, p);
      all.left = std::min(all.left, x), all.right = std::max(all.right, x);
      all.low = std::min(all.low, y), all.high = std::max(all.high, y);
    }
  }
  return all;
}

Vec3 unit_of(Vec3 v) { return (1 / std::sqrt(dot(v, v))) * v; }

}  // namespace

Camera Camera::from(Vec3 toward) {
  Camera camera;
  camera.toward = unit_of(toward);
  const bool is_upright = camera.toward.x == 0 && camera.toward.y == 0;
  const Vec3 upwards = is_upright ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  camera.right = unit_of(cross(upwards, camera.toward));
  camera.up = cross(camera.toward, camera.right);
  return camera;
}

Point seen_size(const Scene& scene, const Camera& camera) {
  const Seen all = seen(scene, camera);
  return all.is_empty() ? Point{} : Point{all.right - all.left, all.high - all.low};
}

Projector::Projector(const Scene& scene, const Camera& camera, double width, double height,
                     double margin)
    : camera_(camera) {
  const Seen all = seen(scene, camera);
  if (all.is_empty()) return;
  constexpr double kLeast_mm = 1e-6;
  scale_ = std::min((width - 2 * margin) / std::max(kLeast_mm, all.right - all.left),
                    (height - 2 * margin) / std::max(kLeast_mm, all.high - all.low));
  x_ = width / 2 - scale_ * (all.left + all.right) / 2;
  y_ = height / 2 + scale_ * (all.low + all.high) / 2;
}

Projector Projector::scaled(double scale) const {
  Projector larger = *this;
  larger.scale_ *= scale, larger.x_ *= scale, larger.y_ *= scale;
  return larger;
}

}  // namespace kerf::output::plot
