#pragma once

#include <vector>

#include "features/rewrite/old_ways.hpp"
#include "features/rewrite/planned_row.hpp"

namespace kerf::features {

/// The loop from the point that comes nearest to where `like` begins: at a vertex, if that does.
[[nodiscard]] contour::Contour begun_like(const contour::Contour& loop, const OldLoop& like);

/// The loop from the vertex nearest to a point.
[[nodiscard]] contour::Contour begun_near(const contour::Contour& loop, contour::Vec2 point);

/// The loop from the point that comes nearest to another one.
[[nodiscard]] contour::Contour begun_beside(const contour::Contour& loop, contour::Vec2 point);

/// The rows that go along it, or round it from its first vertex, at a height, as row `like` is fed.
/// What lies on one circle is one arc.
void append_loop(const contour::Contour& loop, double z, std::uint32_t like,
                 std::vector<PlannedRow>& rows);

}  // namespace kerf::features
