#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/place.hpp"
#include "base/source_file.hpp"
#include "drawing/contours/contour_layer.hpp"

namespace kerf::drawing {

/// A file of contours, in its own unit.
struct ContoursFile {
  struct Layer {
    ContourLayer layer;
    std::vector<std::uint32_t> lines;  ///< of each contour
  };
  struct Fault {
    base::Place place;
    std::string what;
  };

  std::string unit = "mm";
  std::vector<Layer> layers;
  std::optional<Fault> fault;  ///< the first one; nothing behind it was read
};

[[nodiscard]] ContoursFile parse_contours(const base::SourceFile& file);

}  // namespace kerf::drawing
