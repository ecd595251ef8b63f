#pragma once

#include <array>
#include <vector>

namespace kerf::output::plot {

/// Depths and normals by pixels, as they are after bands of samples were resolved.
struct Relief {
  int width = 0;
  int height = 0;
  std::vector<float> depths;                  ///< mm; -infinity: nothing
  std::vector<std::array<float, 3>> normals;  ///< to the right, up, to who looks

  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// How much of the sky each pixel of a row sees past what lies around it, 0 to 1: the mean over
/// places of a disc, near ones and far ones, each counting by how high it stands above the pixel's
/// plane. `mm`: of a pixel, `reach_px`: radius of the larger disc.
void shade_row(const Relief& relief, int row, float mm, float reach_px, std::vector<float>& open);

/// The mean of 4 x 4 pixels that lie about in one plane, which is how many different discs
/// shade_row() has.
[[nodiscard]] float smoothed(const Relief& relief, const std::vector<float>& open, int x, int y,
                             float mm);

}  // namespace kerf::output::plot
