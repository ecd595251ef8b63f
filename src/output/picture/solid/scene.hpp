#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"
#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

using geometry::Vec3;

/// Something that is shown. Its triangles are seen from both sides, the outer one is lit.
struct Body {
  const mesh::TriangleMesh* mesh = nullptr;  ///< outlives the scene
  /// Of each triangle its paint, a number into Scene::paints.
  std::vector<std::uint16_t> paints;
};

struct Scene {
  std::vector<Body> bodies;
  std::vector<Color> paints;
};

/// From where a scene is seen: unit vectors, right-handed in this order, and no perspective.
struct Camera {
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 toward{0, 0, 1};  ///< to who looks

  /// Z is up as far as it can be; straight from above or below, Y is. Precondition: not 0.
  [[nodiscard]] static Camera from(Vec3 toward);
};

/// Space on an image: pixels to the right and down from its upper left corner.
class Projector {
 public:
  /// Shows all points of the scene within the image, `margin` pixels from its border.
  Projector(const Scene& scene, const Camera& camera, double width, double height, double margin);
  /// The same picture on an image that is larger by `scale`.
  [[nodiscard]] Projector scaled(double scale) const;

  [[nodiscard]] Point map(Vec3 p) const {
    return {x_ + scale_ * dot(camera_.right, p), y_ - scale_ * dot(camera_.up, p)};
  }
  /// mm, larger is nearer.
  [[nodiscard]] double depth(Vec3 p) const { return dot(camera_.toward, p); }
  [[nodiscard]] double pixels_per_mm() const { return scale_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }

 private:
  Camera camera_;
  double scale_ = 1;
  double x_ = 0;
  double y_ = 0;
};

/// How large the scene is across the camera, mm; 0, 0: it is empty.
[[nodiscard]] Point seen_size(const Scene& scene, const Camera& camera);

}  // namespace kerf::output::plot
