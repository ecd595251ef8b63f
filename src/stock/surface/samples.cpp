#include "stock/surface/samples.hpp"

#include <algorithm>
#include <limits>

namespace kerf::stock::surface {

void Samples::set_points(std::array<std::vector<double>, 3> points, double slack_mm) {
  points_ = std::move(points);
  slack_ = slack_mm;
  cell_ = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& each : points_) {
    for (std::size_t i = 1; i < each.size(); ++i) cell_ = std::min(cell_, each[i] - each[i - 1]);
  }
}

}  // namespace kerf::stock::surface
