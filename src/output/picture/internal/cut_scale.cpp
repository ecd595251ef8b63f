#include "output/picture/internal/cut_scale.hpp"

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

constexpr Color kBurn{214, 39, 40};

std::uint8_t between(std::uint8_t low, std::uint8_t high, double share) {
  return static_cast<std::uint8_t>(low + (high - low) * share + 0.5);
}

// `share_of_all` from 0, dark, to 1.
Color viridis(double share_of_all) {
  const double at = share_of_all * (kViridis.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const Color a = kViridis[low], b = kViridis[low + 1];
  const double share = at - static_cast<double>(low);
  return {between(a.red, b.red, share), between(a.green, b.green, share),
          between(a.blue, b.blue, share)};
}

}  // namespace

CutScale CutScale::with_shades(std::size_t shades) const {
  CutScale scale = *this;
  scale.shades_ = std::max(shades, kFewestShades);
  return scale;
}

std::size_t CutScale::shade(double value) const {
  if (of_ == Of::energies && value > top_) return 0;
  const bool at_top = !(value < top_);
  const double scaled = at_top ? 0 : value / top_ * static_cast<double>(steps());
  const std::size_t step = at_top ? (top_ > 0 ? steps() - 1 : 0)
                                  : std::min(static_cast<std::size_t>(scaled), steps() - 1);
  return of_ == Of::speeds ? step : shades_ - 1 - step;
}

double CutScale::border(std::size_t shade) const {
  const std::size_t step = of_ == Of::speeds ? shade : shades_ - shade;
  return top_ * static_cast<double>(step) / static_cast<double>(steps());
}

Color CutScale::color(std::size_t shade) const {
  if (of_ == Of::energies && shade == 0) return kBurn;
  const std::size_t step = of_ == Of::speeds ? shade : shade - 1;
  return viridis(static_cast<double>(step) / static_cast<double>(steps() - 1));
}

Color CutScale::color_from_below(std::size_t place) const {
  return color(of_ == Of::speeds ? place : shades_ - 1 - place);
}

}  // namespace kerf::output::plot
