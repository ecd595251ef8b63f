#include "output/solid/solid_file.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::output {

std::array<std::uint8_t, 3> deviation_color(double share) {
  constexpr std::array<double, 3> kGrey{200, 200, 200};
  constexpr std::array<double, 3> kBlue{33, 84, 196};
  constexpr std::array<double, 3> kRed{204, 36, 40};
  const auto& end = share < 0 ? kBlue : kRed;
  const double by = std::min(1.0, std::fabs(share));
  std::array<std::uint8_t, 3> color{};
  for (std::size_t i = 0; i < 3; ++i)
    color[i] = static_cast<std::uint8_t>(std::nearbyint(kGrey[i] + by * (end[i] - kGrey[i])));
  return color;
}

}  // namespace kerf::output
