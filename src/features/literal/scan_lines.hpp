#pragma once

#include <cstdint>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// How contours lie to each other, as lines across both of them see it.
enum class ScanRelation : std::uint8_t {
  undecided,  ///< no line counts
  none,       ///< neither crosses nor is contained: also where the second contains the first
  contains,   ///< the first the second
  partial
};

/// The source's rule: `count` lines each of x = const and y = const, equally spaced over both. A
/// line counts if it crosses both contours, each an even number of times and none at the end of an
/// edge. The crossings with the first, sorted and paired, are ranges; those with the second lie all
/// in them, all outside, or neither.
///
/// It goes by points, so a thin part between two lines is missed, and a chord over a gap is not
/// seen: what is decided is decided by contour::relation(). Linear in the edges times `count`.
[[nodiscard]] ScanRelation scan_relation(const contour::Contour& first,
                                         const contour::Contour& second, int count = 16);

}  // namespace kerf::features
