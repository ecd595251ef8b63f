#include "features/path/united.hpp"

#include <algorithm>
#include <iterator>

#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

using contour::Region;

constexpr std::size_t kAtOnce = 16;

Region united_some(std::vector<Region>& parts, std::size_t begin, std::size_t end) {
  if (end - begin == 1) return std::move(parts[begin]);
  const auto at = [&](std::size_t i) {
    return std::make_move_iterator(parts.begin() + static_cast<std::ptrdiff_t>(i));
  };
  return contour::unite(std::vector<Region>(at(begin), at(end)));
}

}  // namespace

std::optional<Region> united(std::vector<Region> parts, Allowance& allowance) {
  while (parts.size() > 1) {
    std::vector<Region> wider;
    for (std::size_t begin = 0; begin < parts.size(); begin += kAtOnce) {
      if (allowance.is_over()) return std::nullopt;
      wider.push_back(united_some(parts, begin, std::min(parts.size(), begin + kAtOnce)));
    }
    parts = std::move(wider);
  }
  return parts.empty() ? Region{} : std::move(parts.front());
}

}  // namespace kerf::features
