#include "stock/compare/deviation.hpp"

#include <algorithm>
#include <cmath>

#include "stock/compare/internal/threads.hpp"

namespace kerf::stock::compare {
namespace {

// Neighbours in a row are mostly neighbours in space: each search begins where the last one ended.
constexpr std::size_t kRow = 1024;

constexpr Colour kBlue{32, 80, 220};
constexpr Colour kGrey{176, 176, 176};
constexpr Colour kRed{220, 48, 32};

}  // namespace

std::vector<float> deviations_mm(const Solid& design, std::span<const Vec3> places, unsigned jobs) {
  std::vector<float> deviations(places.size());
  each_by_threads((places.size() + kRow - 1) / kRow, jobs, [&](std::size_t row) {
    Hint hint;
    const std::size_t end = std::min(places.size(), (row + 1) * kRow);
    for (std::size_t i = row * kRow; i < end; ++i)
      deviations[i] = static_cast<float>(design.near(places[i], hint).distance_mm);
  });
  return deviations;
}

Colour colour_of_deviation(double deviation_mm, double tolerance_mm) {
  const double full = 2 * tolerance_mm;
  const double sign = (deviation_mm > 0) - (deviation_mm < 0);
  const double share = full > 0 ? std::clamp(deviation_mm / full, -1.0, 1.0) : sign;
  const Colour& end = share < 0 ? kBlue : kRed;
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const double mixed = kGrey[i] + std::fabs(share) * (end[i] - kGrey[i]);
    colour[i] = static_cast<std::uint8_t>(std::nearbyint(mixed));
  }
  return colour;
}

}  // namespace kerf::stock::compare
