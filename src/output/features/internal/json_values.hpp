#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/contour/contour.hpp"
#include "output/features/internal/lines.hpp"

namespace kerf::output {

// Values of the tree of features as JSON; numbers rounded to 1e-6.

[[nodiscard]] std::string rounded(double value);
[[nodiscard]] std::string rounded_or_null(const std::optional<double>& value);
[[nodiscard]] std::string point_json(geometry::Vec2 at);
[[nodiscard]] std::string pair_json(double first, double second);
/// [[x, y, bulge]…]
[[nodiscard]] std::string contour_json(const contour::Contour& contour);
[[nodiscard]] std::string contours_json(const std::vector<contour::Contour>& contours);
[[nodiscard]] std::string rounded_numbers_json(const std::vector<double>& values);
/// [first, last]
[[nodiscard]] std::string lines_json(const LineRange& lines);
/// "F3", or null.
[[nodiscard]] std::string id_of(std::string_view letter, std::size_t place);

}  // namespace kerf::output
