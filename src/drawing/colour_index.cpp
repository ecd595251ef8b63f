#include "drawing/colour_index.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace kerf::drawing {
namespace {

constexpr std::array<std::uint32_t, 10> kNamed{0x000000, 0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF,
                                               0x0000FF, 0xFF00FF, 0xFFFFFF, 0x808080, 0xC0C0C0};
constexpr std::array<std::uint32_t, 6> kGreys{0x333333, 0x505050, 0x696969,
                                              0x828282, 0xBEBEBE, 0xFFFFFF};
constexpr int kFirstHue = 10;
constexpr int kFirstGrey = 250;
constexpr int kLast = 255;

std::uint32_t red_green_blue(double red, double green, double blue) {
  const auto byte = [](double share) { return static_cast<std::uint32_t>(share * 255); };
  return (byte(red) << 16U) | (byte(green) << 8U) | byte(blue);
}

// Of a hue one channel is full, one is least, and one goes up or down in quarters from one sixth of
// the circle to the next.
std::uint32_t hue_of(int number, double full, double least) {
  const int sixth = number / 4;
  const double share = 0.25 * (number % 4);
  const double up = least + (full - least) * share;
  const double down = full - (full - least) * share;
  switch (sixth) {
    case 0: return red_green_blue(full, up, least);
    case 1: return red_green_blue(down, full, least);
    case 2: return red_green_blue(least, full, up);
    case 3: return red_green_blue(least, down, full);
    case 4: return red_green_blue(up, least, full);
    default: return red_green_blue(full, least, down);
  }
}

std::uint32_t shade_of(int index) {
  constexpr std::array<double, 5> kShades{1, 0.65, 0.5, 0.3, 0.15};
  const double full = kShades[static_cast<std::size_t>(index % 10 / 2)];
  return hue_of(index / 10 - 1, full, index % 2 == 0 ? 0 : 0.5 * full);
}

}  // namespace

Colour colour_of_index(int index) {
  if (index < 1 || index > kLast) index = kForeground;
  if (index < kFirstHue) return Colour{kNamed[static_cast<std::size_t>(index)]};
  if (index < kFirstGrey) return Colour{shade_of(index)};
  return Colour{kGreys[static_cast<std::size_t>(index - kFirstGrey)]};
}

int nearest_index(Colour colour) {
  if (colour == Colour{}) return kForeground;
  const auto channel = [](Colour of, unsigned shift) {
    return static_cast<int>((static_cast<std::uint32_t>(of) >> shift) & 0xFFU);
  };
  int nearest = 1;
  int least = std::numeric_limits<int>::max();
  for (int index = 1; index <= kLast; ++index) {
    int away = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
      const int way = channel(colour, shift) - channel(colour_of_index(index), shift);
      away += way * way;
    }
    if (away >= least) continue;
    nearest = index;
    least = away;
  }
  return nearest;
}

}  // namespace kerf::drawing
