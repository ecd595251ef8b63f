#pragma once

#include <span>
#include <vector>

#include "stock/compare/solid.hpp"

namespace kerf::stock::compare {

/// How far each place is from the surface of a design: positive outside, where a part has material
/// left, negative inside, where it was cut into the design. Which is what colours a picture of the
/// part. `jobs` threads; their number changes no bit. Precondition: jobs > 0.
[[nodiscard]] std::vector<float> deviations_mm(const Solid& design, std::span<const Vec3> places,
                                               unsigned jobs);

}  // namespace kerf::stock::compare
