#pragma once

#include <vector>

#include "output/picture/solid/scene.hpp"

namespace kerf::output::plot {

/// A rendered scene: colours by rows from above, and how near what is seen there is.
struct Rendering {
  Image image;
  std::vector<float> depths;  ///< mm as Projector::depth(); below all of the scene: nothing is seen

  /// Whether a place of the scene is hidden by more than `slack_mm`; `at`: pixels of the image.
  [[nodiscard]] bool hides(Point at, double depth_mm, double slack_mm) const;
};

/// Draws the scene: lit from the upper left, edges of shapes and of paints as fine lines, corners a
/// little darker, borders smooth, on a pale ground. `jobs` threads, 0: one a processor; the bytes
/// do not depend on them.
[[nodiscard]] Rendering render(const Scene& scene, const Projector& projector, int width,
                               int height, unsigned jobs);

}  // namespace kerf::output::plot
