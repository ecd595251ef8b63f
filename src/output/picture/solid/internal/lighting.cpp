#include "output/picture/solid/internal/lighting.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr std::size_t kSteps = 8192;
constexpr float kCrease = 0.90F;    // cosine: flatter edges have no line
constexpr float kJump = 2.0F;       // samples: steps in depth that are an edge
constexpr float kSteepest = 0.08F;  // of a normal's part to who looks

double decoded(double value) {
  return value <= 0.04045 ? value / 12.92 : math::pow((value + 0.055) / 1.055, 2.4);
}
double encoded_value(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * math::pow(light, 1 / 2.4) - 0.055;
}

float dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Towards the lamps: from the upper left before it, from the right, from below behind.
constexpr std::array<float, 3> kKey{-0.418F, 0.640F, 0.645F};
constexpr std::array<float, 3> kFill{0.850F, 0.120F, 0.513F};
constexpr std::array<float, 3> kGloss{-0.230F, 0.353F, 0.907F};  // half-way to who looks
constexpr float kKeyLight = 0.74F, kFillLight = 0.20F, kGround = 0.20F, kSky = 0.34F;
constexpr float kGlossLight = 0.16F;

}  // namespace

Tone::Tone() {
  for (std::size_t i = 0; i < decoded_.size(); ++i)
    decoded_[i] = static_cast<float>(decoded(static_cast<double>(i) / 255));
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double value = encoded_value(static_cast<double>(i) / kSteps);
    encoded_.push_back(
        static_cast<std::uint8_t>(std::nearbyint(255 * std::clamp(value, 0.0, 1.0))));
  }
}

std::uint8_t Tone::encoded(float light) const {
  const float at = std::clamp(light, 0.0F, 1.0F) * static_cast<float>(kSteps);
  return encoded_[static_cast<std::size_t>(at + 0.5F)];
}

Light lit(const Light& paint, const std::array<float, 3>& normal, float upright) {
  const float key = std::max(0.0F, dot(normal, kKey));
  const float fill = std::max(0.0F, dot(normal, kFill));
  const float sky = kGround + (kSky - kGround) * (0.5F + 0.5F * upright);
  float gloss = std::max(0.0F, dot(normal, kGloss));
  for (int i = 0; i < 5; ++i) gloss *= gloss;  // to the 32nd
  const float light = kKeyLight * key + kFillLight * fill + sky;
  Light out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = paint[i] * light + kGlossLight * gloss;
  return out;
}

Line line_between(const Sample& a, const Sample& b, int dx, int dy, float mm) {
  const bool nothing = a.body == Sample::kNothing || b.body == Sample::kNothing;
  if (nothing) return a.body == b.body ? Line::none : Line::outline;
  // Where the planes of both say that the other lies.
  const auto step = [&](const Sample& s) {
    const float slope =
        (static_cast<float>(dx) * s.normal[0] - static_cast<float>(dy) * s.normal[1]) /
        std::max(kSteepest, s.normal[2]);
    return -slope * mm;
  };
  const float jump = b.depth - a.depth;
  const float off = std::min(std::fabs(jump - step(a)), std::fabs(jump - step(b)));
  const float steep = std::max(std::fabs(step(a)), std::fabs(step(b)));
  if (off > kJump * mm + 0.7F * steep) return Line::outline;
  if (dot(a.normal, b.normal) < kCrease || a.body != b.body) return Line::edge;
  return a.paint == b.paint ? Line::none : Line::paint;
}

}  // namespace kerf::output::plot
