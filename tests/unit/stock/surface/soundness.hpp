#pragma once

#include <cstdint>
#include <string>

#include "stock/surface/surface.hpp"

namespace kerf::stock::surface::test {

/// What a reader of STL finds: corners with the same float32 are one.
struct Soundness {
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::size_t shells = 0;    ///< that hang together by edges
  std::size_t open = 0;      ///< edges of one triangle, or of two in the same direction
  std::size_t crowded = 0;   ///< edges of more than two
  std::size_t flat = 0;      ///< triangles without area
  std::size_t repeated = 0;  ///< triangles that have the corners of another
  std::size_t merged = 0;    ///< points that lie on another
  long euler = 0;
  double volume_mm3 = 0;

  [[nodiscard]] bool is_sound() const { return open + crowded + flat + repeated + merged == 0; }
  [[nodiscard]] std::string text() const;
};
[[nodiscard]] Soundness soundness(const Surface& surface);

}  // namespace kerf::stock::surface::test
