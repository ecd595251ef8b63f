#pragma once

#include <cstddef>

#include "stock/surface/surface.hpp"

namespace kerf::stock::surface {

/// The same surface with at most `triangles` triangles, or with as few as there can be: edges are
/// drawn together to points, those first that change it least (the planes of all triangles that a
/// point stands for, by their areas: quadrics of error), so flat faces lose their triangles before
/// edges and round ones do. It stays a Surface: closed, oriented, of as many pieces and handles; no
/// triangle turns over. Each triangle keeps its owner. Of a surface that has no more it is that.
///
/// About n log n; 150 bytes a triangle beside it. The same bytes everywhere.
[[nodiscard]] Surface simplified(Surface surface, std::size_t triangles);

}  // namespace kerf::stock::surface
