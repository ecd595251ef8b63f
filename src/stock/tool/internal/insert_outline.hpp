#pragma once

#include <string>

#include "stock/tool/insert.hpp"

namespace kerf::stock {

// Inserts in the two positions that the others are mirrored from: T3, the tip points to -Z and -ρ,
// and T8, symmetric about the direction -ρ that it points to.

/// Turning and boring: nose, main and minor edge, the rest of a body about its inscribed circle.
[[nodiscard]] Insert nosed_insert(const Tool& tool, bool is_symmetric);
/// Grooving and parting: straight sides that cut up to flute_length.
[[nodiscard]] Insert blade(const Tool& tool, bool is_symmetric);
/// Threading: a V, one pitch wide where that is said.
[[nodiscard]] Insert thread_point(const Tool& tool, bool is_symmetric);

[[nodiscard]] contour::Contour rectangle(contour::Vec2 low, contour::Vec2 high, InsertPart part);

/// Why none of them can be, or nothing.
[[nodiscard]] std::string objection_to_outline(const Tool& tool);

}  // namespace kerf::stock
