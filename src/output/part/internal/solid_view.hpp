#pragma once

#include "output/part/internal/paints.hpp"
#include "output/part/part_picture.hpp"
#include "output/picture/solid/renderer.hpp"
#include "output/picture/solid/scene.hpp"

namespace kerf::output::plot {

/// The solids of a scene on a sheet: rendered, with axes, a scale and the marks of findings.
class SolidView {
 public:
  /// All outlive it.
  SolidView(const PartScene& scene, const Paints& paints, const Camera& camera);

  /// For the solids to fill a frame of this width.
  [[nodiscard]] double height_for(double width) const;
  void draw(DisplayList& sheet, const Rect& frame) const;

 private:
  void draw_threads(DisplayList& sheet, const Rect& frame, const Rendering& rendering,
                    const Projector& projector) const;
  void draw_axes(DisplayList& sheet, Point origin) const;

  const PartScene& scene_;
  Camera camera_;
  Scene solids_;
};

}  // namespace kerf::output::plot
