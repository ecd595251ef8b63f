#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/internal/pair.hpp"
#include "math/math.hpp"

namespace kerf::math {
namespace {

constexpr double kLarge = 0x1p500;
constexpr double kSmall = 0x1p-450;
constexpr double kScale = 0x1p600;
constexpr double kCubeRootOfScale = 0x1p200;

double root(Pair x) {
  const double first = std::sqrt(x.high);
  const Pair back = square(first);
  return first + ((x.high - back.high) - back.low + x.low) / (2 * first);
}

// Of numbers of which the largest is neither so large nor so small that its square is lost.
double root_of_squares(double x, double y) { return root(sum(square(x), square(y))); }

double root_of_squares(double x, double y, double z) {
  return root(sum(sum(square(x), square(y)), square(z)));
}

double infinite_or_none(bool infinite) {
  return infinite ? std::numeric_limits<double>::infinity()
                  : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double hypot(double x, double y) {
  x = std::fabs(x);
  y = std::fabs(y);
  const double most = std::max(x, y);
  if (most < kLarge && most > kSmall) return root_of_squares(x, y);
  if (!(x + y < std::numeric_limits<double>::infinity()) &&
      (std::isinf(x) || std::isinf(y) || std::isnan(x) || std::isnan(y)))
    return infinite_or_none(std::isinf(x) || std::isinf(y));
  if (most == 0) return 0;
  const double scale = most >= kLarge ? 1 / kScale : kScale;
  return root_of_squares(x * scale, y * scale) / scale;
}

double hypot(double x, double y, double z) {
  x = std::fabs(x);
  y = std::fabs(y);
  z = std::fabs(z);
  const double most = std::max({x, y, z});
  const bool numbers = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  if (!numbers) return infinite_or_none(std::isinf(x) || std::isinf(y) || std::isinf(z));
  if (most < kLarge && most > kSmall) return root_of_squares(x, y, z);
  if (most == 0) return 0;
  const double scale = most >= kLarge ? 1 / kScale : kScale;
  return root_of_squares(x * scale, y * scale, z * scale) / scale;
}

// A first guess from a third of the exponent, which is off by at most 6 %; Halley's step makes
// that 2e-4 · 1e-11; the last one corrects by the exact cube.
double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  double size = std::fabs(x);
  double scale = 1;
  if (size < kSmall) {
    size *= kScale;
    scale = kCubeRootOfScale;
  } else if (size > kLarge) {
    size /= kScale;
    scale = 1 / kCubeRootOfScale;
  }
  constexpr std::uint64_t kTwoThirdsOfBias = 0x2A9F7893782DA1CEULL;
  double guess = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + kTwoThirdsOfBias);
  for (int i = 0; i < 2; ++i) {
    const double cube = guess * guess * guess;
    guess *= (cube + 2 * size) / (2 * cube + size);
  }
  const Pair cube = product(square(guess), guess);
  const double rest = (size - cube.high) - cube.low;
  return std::copysign((guess + rest / (3 * guess * guess)) / scale, x);
}

}  // namespace kerf::math
