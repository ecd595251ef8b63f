#include "stock/compare/deviation.hpp"

#include <algorithm>

#include "base/each_by_threads.hpp"

namespace kerf::stock::compare {
namespace {

// Neighbours in a row are mostly neighbours in space: each search begins where the last one ended.
constexpr std::size_t kRow = 1024;

}  // namespace

std::vector<float> deviations_mm(const Solid& design, std::span<const Vec3> places, unsigned jobs) {
  std::vector<float> deviations(places.size());
  base::each_by_threads(
      (places.size() + kRow - 1) / kRow, base::useful_threads(jobs), [&](std::size_t row) {
        Hint hint;
        const std::size_t end = std::min(places.size(), (row + 1) * kRow);
        for (std::size_t i = row * kRow; i < end; ++i)
          deviations[i] = static_cast<float>(design.near(places[i], hint).distance_mm);
      });
  return deviations;
}

}  // namespace kerf::stock::compare
