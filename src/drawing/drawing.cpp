#include "drawing/drawing.hpp"

#include <fmt/format.h>

namespace kerf::drawing {

std::string text_of(Colour colour) {
  return fmt::format("#{:06x}", static_cast<std::uint32_t>(colour));
}

contour::Contour contour_of(const Drawing& drawing, const Path& path) {
  const auto begin = drawing.vertices.begin() + static_cast<std::ptrdiff_t>(path.first);
  return {{begin, begin + path.count}, path.is_closed};
}

}  // namespace kerf::drawing
