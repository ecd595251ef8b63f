#pragma once

#include <string>
#include <vector>

#include "stock/sweep/way.hpp"

namespace kerf::output {

// Places of the stock as reports have them. `turns`: of a part that turns, whose X is a diameter
// and which has no Y.

[[nodiscard]] std::string point_json(stock::Vec3 at, bool turns);
/// Low > high: an empty object.
[[nodiscard]] std::string bounds_json(const stock::Bounds& box, bool turns);
[[nodiscard]] std::string numbers_json(const std::vector<double>& values);

}  // namespace kerf::output
