#pragma once

#include <string>

#include "output/picture/drawing/display_list.hpp"

namespace kerf::output::plot {

/// The drawing as a PNG file of `scale` pixels to a unit. Throws std::bad_alloc without memory.
[[nodiscard]] std::string write_png(const DisplayList& drawing, double scale);

/// An image alone as a PNG file. Likewise.
[[nodiscard]] std::string write_png(const Image& image);

}  // namespace kerf::output::plot
