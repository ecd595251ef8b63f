#include "output/internal/plot/speed_scale.hpp"

#include <algorithm>
#include <array>

namespace kerf::output::plot {
namespace {

// Viridis (matplotlib) at every tenth up to 0.8: what is lighter does not show on white.
constexpr std::array<Color, 9> kViridis{{{68, 1, 84},
                                         {72, 36, 117},
                                         {65, 68, 135},
                                         {53, 95, 141},
                                         {42, 120, 142},
                                         {33, 145, 140},
                                         {34, 168, 132},
                                         {68, 191, 112},
                                         {122, 209, 81}}};

std::uint8_t between(std::uint8_t low, std::uint8_t high, double share) {
  return static_cast<std::uint8_t>(low + (high - low) * share + 0.5);
}

}  // namespace

std::size_t SpeedScale::shade(double speed) const {
  if (!(speed < fastest_)) return fastest_ > 0 ? shades_ - 1 : 0;
  const double scaled = speed / fastest_ * static_cast<double>(shades_);
  return std::min(static_cast<std::size_t>(scaled), shades_ - 1);
}

Color SpeedScale::color(std::size_t shade) const {
  const double share_of_all = static_cast<double>(shade) / static_cast<double>(shades_ - 1);
  const double at = share_of_all * (kViridis.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const Color a = kViridis[low], b = kViridis[low + 1];
  const double share = at - static_cast<double>(low);
  return {between(a.red, b.red, share), between(a.green, b.green, share),
          between(a.blue, b.blue, share)};
}

}  // namespace kerf::output::plot
