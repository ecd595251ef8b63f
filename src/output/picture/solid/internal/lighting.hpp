#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/solid/internal/band.hpp"

namespace kerf::output::plot {

/// Red, green, blue as light, 0 to 1.
using Light = std::array<float, 3>;

/// sRGB to light and back.
class Tone {
 public:
  Tone();
  [[nodiscard]] Light light(Color color) const {
    return {decoded_[color.red], decoded_[color.green], decoded_[color.blue]};
  }
  [[nodiscard]] std::uint8_t encoded(float light) const;

 private:
  std::array<float, 256> decoded_{};
  std::vector<std::uint8_t> encoded_;
};

/// A matt surface with a little gloss under three lamps and the sky.
/// `normal`: to the right, up, to who looks; `upright`: how far it looks to the sky, -1 to 1.
[[nodiscard]] Light lit(const Light& paint, const std::array<float, 3>& normal, float upright);

/// Whether a line of the drawing runs between two neighbouring samples: an edge, the border of a
/// paint, or one thing in front of another. `dx`, `dy`: from the first to the second, samples to
/// the right and down; `mm`: the size of a sample.
enum class Line : std::uint8_t { none, paint, edge, outline };
[[nodiscard]] Line line_between(const Sample& a, const Sample& b, int dx, int dy, float mm);

}  // namespace kerf::output::plot
