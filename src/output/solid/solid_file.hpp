#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stock/surface/surface.hpp"

namespace kerf::output {

/// How far the part is from its design, point by point of the piece.
struct Deviations {
  std::vector<float> mm;    ///< of each point: > 0 material is left, < 0 too much is cut
  double tolerance_mm = 0;  ///< blue at -2 of it, grey at 0, red at +2
};

/// A piece of a part with what formats beyond STL can say of it.
struct SolidPiece {
  stock::surface::Surface surface;
  std::vector<std::uint16_t> materials;  ///< of triangles, into SolidFile::materials
  std::optional<Deviations> deviations{};
};

/// What a file of solids holds. mm, Z up.
struct SolidFile {
  struct Material {
    std::string name;
    std::array<std::uint8_t, 3> color{};  ///< sRGB
  };
  std::string name;
  std::vector<Material> materials;
  std::vector<SolidPiece> pieces;
};

/// sRGB of a deviation: from blue (-1) by grey (0) to red (1), `share` clamped to that.
[[nodiscard]] std::array<std::uint8_t, 3> deviation_color(double share);

}  // namespace kerf::output
