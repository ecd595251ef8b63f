#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "stock/compare/solid.hpp"

namespace kerf::stock::compare {

/// How far each place is from the surface of a design: positive outside, where a part has material
/// left, negative inside, where it was cut into the design. Which is what colours a picture of the
/// part. `jobs` threads; their number changes no bit. Precondition: jobs > 0.
[[nodiscard]] std::vector<float> deviations_mm(const Solid& design, std::span<const Vec3> places,
                                               unsigned jobs);

/// The colour of a deviation: red, green, blue of 255. Grey is 0, blue -2 tolerances and less, red
/// +2 tolerances and more, and linear in between.
using Colour = std::array<std::uint8_t, 3>;
[[nodiscard]] Colour colour_of_deviation(double deviation_mm, double tolerance_mm);

}  // namespace kerf::stock::compare
