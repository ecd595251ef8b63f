#pragma once

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// The form in which contours are told: a closed one goes round counterclockwise and begins at the
/// vertex of least x, then least y; neighbours on one line or circle are one edge; no arc turns by
/// more than half a circle and what words are rounded to, a whole circle is two halves from its
/// leftmost point. An open one keeps its direction and its ends.
[[nodiscard]] contour::Contour normal_form(const contour::Contour& contour);

/// A closed contour without its edges that are shorter than `least`: the one before ends
/// where the next long one begins. Words are rounded, and what touches on a drawing leaves such
/// edges in a program.
[[nodiscard]] contour::Contour without_slivers(const contour::Contour& contour, double least);

/// A loop that is no wider than what words are rounded to: nothing that somebody meant.
[[nodiscard]] bool is_sliver(const contour::Contour& loop);

/// Whether two closed contours in normal form are one, point for point within `tolerance`.
[[nodiscard]] bool are_equal(const contour::Contour& a, const contour::Contour& b,
                             double tolerance);

}  // namespace kerf::features
