#pragma once

#include <vector>

#include "geometry/contour/contour.hpp"
#include "job/internal/edit_operations.hpp"

namespace kerf::job {

// Points and contours of an edits file. Throw Misread.

/// [x, y]; of a lathe [z, x].
[[nodiscard]] contour::Vec2 point_at(EditReading& reading, std::size_t value,
                                     const std::string& what);
/// A list of [x, y] or [x, y, bulge], `least` points or more.
[[nodiscard]] contour::Contour contour_at(EditReading& reading, std::size_t value, bool is_closed);
[[nodiscard]] std::vector<contour::Contour> contours_at(EditReading& reading, std::size_t value);

}  // namespace kerf::job
