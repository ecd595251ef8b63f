#include "output/picture/solid/internal/corner_shade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr int kPlaces = 14;     // of each disc
constexpr int kPatterns = 16;   // discs turned against each other
constexpr float kLean = 0.10F;  // sine: what stands lower above the plane shades nothing
constexpr float kStrength = 1.9F;

struct Offset {
  float x;
  float y;
};
using Disc = std::array<Offset, kPlaces>;

/// A spiral of the golden angle, turned a little more for each pattern.
std::array<Disc, kPatterns> discs() {
  constexpr double kGolden = 2.399963229728653;
  std::array<Disc, kPatterns> all{};
  for (int p = 0; p < kPatterns; ++p) {
    for (int i = 0; i < kPlaces; ++i) {
      const double turn = kGolden * i + 2 * std::numbers::pi * (p * 7 % kPatterns) / kPatterns;
      const double r = std::sqrt((i + 0.5 + 0.4 * (p % 4) / 4) / (kPlaces + 0.5));
      const auto [sine, cosine] = math::sine_cosine(turn);
      all[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)] = {
          static_cast<float>(r * cosine), static_cast<float>(r * sine)};
    }
  }
  return all;
}

/// What one disc around a pixel hides.
float hidden(const Relief& relief, int x, int y, float mm, float reach_px, const Disc& disc) {
  const std::size_t here = relief.at(x, y);
  const float depth = relief.depths[here];
  const std::array<float, 3>& n = relief.normals[here];
  const float reach = reach_px * mm;
  float sum = 0;
  for (const Offset& each : disc) {
    const int px = x + static_cast<int>(std::nearbyint(each.x * reach_px));
    const int py = y + static_cast<int>(std::nearbyint(each.y * reach_px));
    if (px < 0 || py < 0 || px >= relief.width || py >= relief.height) continue;
    const float other = relief.depths[relief.at(px, py)];
    if (!std::isfinite(other)) continue;
    const float vx = static_cast<float>(px - x) * mm;
    const float vy = static_cast<float>(y - py) * mm;
    const float vz = other - depth;
    const float square = vx * vx + vy * vy + vz * vz;
    if (!(square > 0)) continue;
    const float rise = (vx * n[0] + vy * n[1] + vz * n[2]) / std::sqrt(square);
    const float fade = 1 - square / (4 * reach * reach);
    if (rise > kLean && fade > 0) sum += (rise - kLean) * fade;
  }
  return sum / kPlaces;
}

}  // namespace

void shade_row(const Relief& relief, int row, float mm, float reach_px, std::vector<float>& open) {
  static const std::array<Disc, kPatterns> kDiscs = discs();
  for (int x = 0; x < relief.width; ++x) {
    float& value = open[relief.at(x, row)];
    value = 1;
    if (!std::isfinite(relief.depths[relief.at(x, row)])) continue;
    const Disc& disc = kDiscs[static_cast<std::size_t>(x % 4 * 4 + row % 4)];
    const float near = hidden(relief, x, row, mm, reach_px / 4, disc);
    const float far = hidden(relief, x, row, mm, reach_px, disc);
    value = std::max(0.0F, 1 - kStrength * (0.45F * near + 0.75F * far));
  }
}

float smoothed(const Relief& relief, const std::vector<float>& open, int x, int y, float mm) {
  const std::size_t here = relief.at(x, y);
  const std::array<float, 3>& n = relief.normals[here];
  float sum = 0;
  float count = 0;
  for (int dy = -2; dy < 2; ++dy) {
    for (int dx = -2; dx < 2; ++dx) {
      const int px = std::clamp(x + dx, 0, relief.width - 1);
      const int py = std::clamp(y + dy, 0, relief.height - 1);
      const std::size_t other = relief.at(px, py);
      const std::array<float, 3>& m = relief.normals[other];
      if (!std::isfinite(relief.depths[other])) continue;
      const float off = std::fabs(relief.depths[other] - relief.depths[here]);
      if (off > 12 * mm || n[0] * m[0] + n[1] * m[1] + n[2] * m[2] < 0.8F) continue;
      sum += open[other];
      count += 1;
    }
  }
  return count > 0 ? sum / count : open[here];
}

}  // namespace kerf::output::plot
