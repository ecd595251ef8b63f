#include "drawing/affine.hpp"

#include <cmath>

namespace kerf::drawing {

Affine Affine::turned(double angle_rad) {
  const double cosine = math::cos(angle_rad);
  const double sine = math::sin(angle_rad);
  return {{cosine, sine}, {-sine, cosine}, {}};
}

std::optional<double> Affine::scale() const {
  constexpr double kSame = 1e-9;
  const double along_x = geometry::length(x);
  const double along_y = geometry::length(y);
  const bool is_square = std::abs(geometry::dot(x, y)) <= kSame * along_x * along_y;
  const bool is_equal = std::abs(along_x - along_y) <= kSame * along_x;
  if (!is_square || !is_equal) return std::nullopt;
  return along_x;
}

}  // namespace kerf::drawing
