#pragma once

#include <cstdint>
#include <span>

#include "geometry/contour/region.hpp"
#include "stock/sheet/trace.hpp"

namespace kerf::stock::sheet {

/// What a beam of this width takes away along the traces, as an area of lines and arcs: both sides
/// of every cut, exact. Its holes are the pieces that fall out. n log n in the number of traces and
/// of places where cuts meet. Edges have the owner of their trace, 0 where there are no `owners`.
/// Precondition: kerf_mm > 0, as many owners as traces, or none.
[[nodiscard]] contour::Region outline_of(std::span<const Trace> traces, double kerf_mm,
                                         std::span<const std::uint32_t> owners = {});

}  // namespace kerf::stock::sheet
