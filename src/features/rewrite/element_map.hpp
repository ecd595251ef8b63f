#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::features {

/// Which element of a contour each one of another has become, both in one sense: those that lie
/// along each other first, the longest common row of them; where as many stand between two of
/// these, in their order. Nothing: it is gone.
[[nodiscard]] std::vector<std::optional<std::size_t>> mapped_elements(
    const contour::Contour& before, const contour::Contour& now);

/// The element that comes nearest to another one, of those that run that way if there are any.
[[nodiscard]] std::size_t nearest_element(const contour::Edge& element,
                                          const contour::Contour& now);

}  // namespace kerf::features
