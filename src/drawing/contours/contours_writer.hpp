#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "drawing/contours/contour_layer.hpp"

namespace kerf::drawing {

/// Takes the next piece of a file.
using WritePiece = std::function<void(std::string_view)>;

/// As read_contours() reads it, the same contours to the last bit; a contour a line.
void write_contours_json(const std::vector<ContourLayer>& layers, const WritePiece& write);

/// DXF R12 in mm: polylines with bulges, points; colours are the nearest of the index.
void write_contours_dxf(const std::vector<ContourLayer>& layers, const WritePiece& write);

/// SVG in mm, a group a layer, named as Inkscape names its layers. The page's lower left corner is
/// the zero, or as far left or below it as the contours go.
void write_contours_svg(const std::vector<ContourLayer>& layers, const WritePiece& write);

}  // namespace kerf::drawing
