#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/internal/exponential_tables.hpp"
#include "math/math.hpp"

namespace kerf::math {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// exp(x) for |x| < 746: with k = 64 x/ln 2 to the nearest, 2^(k/64) exp(x - k ln 2/64).
double exponential(Pair x) {
  const double k = nearest_integer(x.high * k64OverLn2);
  const Pair rest = sum(sum(x.high - k * kLn2Over64Parts[0], -k * kLn2Over64Parts[1]),
                        x.low - k * kLn2Over64Parts[2]);
  const double r = rest.high;
  const double less_one =
      r + (rest.low + r * r * (0.5 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120 + r / 720)))));
  const int steps = static_cast<int>(k);
  const Pair entry = kPowersOf2[static_cast<std::size_t>(steps & 63)];
  const double value = entry.high + (entry.low + entry.high * less_one);
  return std::ldexp(value, steps >> 6);
}

// A number above 0 as 2^exponent m, m in [1/sqrt(2), sqrt(2)), and the interval of the tables that
// m is in.
struct Scaled {
  int exponent = 0;
  double m = 1;
  std::size_t interval = 0;
};

Scaled scaled(double x) {
  int shifted = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    shifted = 54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  Scaled of;
  of.exponent = static_cast<int>(bits >> 52) - 1023 - shifted;
  of.m = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
  of.interval = bits >> 45 & 127;
  constexpr std::size_t kAboveRoot = 53;  // the first interval whose middle is above sqrt(2)
  if (of.interval >= kAboveRoot) {
    of.m /= 2;
    ++of.exponent;
  }
  return of;
}

// ln(1 + z) for |z| < 2^-7: z - z^2/2 + z^3/3 as sums of two, the rest is below 2^-28 z.
Pair logarithm_beside_1(Pair z) {
  const double h = z.high;
  const Pair squared = product(z, z);
  const Pair cubed = product(squared, z);
  const double rest =
      squared.high * squared.high *
      (-1.0 / 4 + h * (1.0 / 5 + h * (-1.0 / 6 + h * (1.0 / 7 + h * (-1.0 / 8 + h / 9)))));
  constexpr Pair kThird{1.0 / 3, 0x1.5555555555555p-56};
  const Pair tail = sum(product(cubed, kThird), rest);
  return sum(sum(z, Pair{-squared.high / 2, -squared.low / 2}), tail);
}

// ln(x), x > 0 and finite, to about 2^-66 of it: with c near 1/m it is e ln 2 - ln c + ln(c m).
Pair logarithm(double x) {
  const Scaled of = scaled(x);
  const double c = kReciprocals[of.interval];
  const Pair cm = product(of.m, c);
  const Pair z = quick_sum(cm.high - 1, cm.low);
  const Pair beside = logarithm_beside_1(z);
  const double e = of.exponent;
  const Pair whole = sum(sum(e * kLn2Parts[0], e * kLn2Parts[1]), kLogarithms[of.interval]);
  return sum(whole, beside);
}

bool is_integer(double x) { return std::trunc(x) == x; }
bool is_odd(double x) { return is_integer(x) && std::fabs(x) < 0x1p53 && std::fmod(x, 2) != 0; }

// Of an infinite or vanishing base or exponent, or one that is 1; x and y are numbers.
double limit_of_power(double x, double y) {
  const double size = std::fabs(x);
  if (size == 1) return 1;
  const bool grows = (size > 1) == (y > 0);
  return grows ? kInfinity : 0;
}

double signed_as_power(double value, double x, double y) {
  return std::signbit(x) && is_odd(y) ? -value : value;
}

// What is asked of a logarithm of a size that is no number or no logarithm has.
bool has_no_logarithm(double x, double& answer) {
  if (std::isnan(x) || x == kInfinity) {
    answer = x;
  } else if (x == 0) {
    answer = -kInfinity;
  } else if (x < 0) {
    answer = kNan;
  } else {
    return false;
  }
  return true;
}

constexpr double kLargestExponent = 709.782712893384;  // of e, whose power is a double
constexpr double kSmallestExponent = -745.1332191019412;

double exponential_in_range(Pair x) {
  if (x.high > kLargestExponent + 1) return kInfinity;
  if (x.high < kSmallestExponent - 1) return 0;
  return exponential(x);
}

}  // namespace

double exp(double x) {
  if (std::isnan(x)) return x;
  return exponential_in_range({x, 0});
}

double log(double x) {
  double answer = 0;
  return has_no_logarithm(x, answer) ? answer : rounded(logarithm(x));
}

// Of a power of two there is nothing to round.
double log2(double x) {
  double answer = 0;
  if (has_no_logarithm(x, answer)) return answer;
  const Scaled of = scaled(x);
  if (of.m == 1) return of.exponent;
  return rounded(product(logarithm(x), kOverLn2));
}

double log10(double x) {
  double answer = 0;
  return has_no_logarithm(x, answer) ? answer : rounded(product(logarithm(x), kOverLn10));
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return kNan;
  if (std::isinf(y)) return limit_of_power(x, y);
  if (x == 0 || std::isinf(x)) return signed_as_power(limit_of_power(x, y), x, y);
  if (x < 0 && !is_integer(y)) return kNan;
  if (std::fabs(y) > 0x1p64) return limit_of_power(x, y);
  const Pair exponent = product(logarithm(std::fabs(x)), y);
  return signed_as_power(exponential_in_range(exponent), x, y);
}

}  // namespace kerf::math
