#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/internal/trigonometric_tables.hpp"
#include "math/math.hpp"

namespace kerf::math {
namespace {

constexpr double kOwnSine = 0x1p-30;  // below, x and its sine, tangent … are less than 2^-60 apart

// An angle as quarter turns and a rest within half a quarter, about.
struct Quarters {
  unsigned count = 0;  // modulo 4
  Pair rest;
};

// A product of at most 20 bits with a part of 33 is exact, and so is the first difference, since x
// is within half a quarter of it. The rest may be as small as 2^-60; the last part ends at 2^-157.
Quarters take_parts(double x) {
  const double n = nearest_integer(x * kTwoOverPi);
  Pair rest = sum(x - n * kHalfPiParts[0], -n * kHalfPiParts[1]);
  rest = sum(rest, -n * kHalfPiParts[2]);
  rest = sum(rest, -n * kHalfPiParts[3]);
  return {static_cast<unsigned>(static_cast<int>(n)) & 3U, rest};
}

// A large angle (Payne and Hanek 1983): its whole number m of last digits 2^e times 2/pi, of whose
// digits those are left out that only make whole turns. Six words: 53 bits of m move a point 192
// bits behind the first one kept, and no double comes closer to a quarter than 2^-62.
Quarters multiply_out(double x) {
  constexpr std::size_t kWords = 7;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7FF) - 1075;  // of the last digit
  const std::uint64_t mantissa = (bits & 0xFFFFFFFFFFFFFULL) | 0x10000000000000ULL;
  // The first word that still matters: digits of 2/pi worth 4 or more in the product drop out.
  const int first = exponent > 2 ? (exponent - 2) / 32 : 0;
  const int shift = exponent - 32 * first;         // in (-54, 34): what is left of the exponent
  std::array<std::uint32_t, kWords + 2> digits{};  // of the product; the last word first
  for (const int half : {0, 1}) {
    const std::uint64_t factor = half == 0 ? mantissa & 0xFFFFFFFF : mantissa >> 32;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < kWords; ++i) {
      const std::size_t at = i + static_cast<std::size_t>(half);
      const std::uint64_t word = kTwoOverPiWords[static_cast<std::size_t>(first) + kWords - 1 - i];
      carry += factor * word + digits[at];
      digits[at] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    digits[kWords + static_cast<std::size_t>(half)] += static_cast<std::uint32_t>(carry);
  }
  // The product counts 2^(shift - 32 kWords): bit 32 kWords - shift is a quarter.
  const int point = 32 * static_cast<int>(kWords) - shift;
  const auto bit = [&](int at) {
    return at >= 0 && (digits[static_cast<std::size_t>(at / 32)] >> (at % 32) & 1U) != 0;
  };
  unsigned count = (bit(point + 1) ? 2U : 0U) + (bit(point) ? 1U : 0U);
  const bool upper_half = bit(point - 1);
  if (upper_half) ++count;
  // The fraction in [-1/2, 1/2), digit by digit into two doubles of 53 bits.
  Pair fraction;
  double worth = 0.5;
  int at = point - 1;
  for (; at >= 0 && bit(at) == upper_half; --at) worth /= 2;
  const double sign = upper_half ? -1 : 1;
  // Of a number below zero the complement counts; its last digit is below all that matters.
  for (int n = 0; n < 106 && at >= 0; ++n, --at, worth /= 2) {
    if (bit(at) == upper_half) continue;
    if (n < 53) {
      fraction.high += sign * worth;
    } else {
      fraction.low += sign * worth;
    }
  }
  return {count & 3U, product(kHalfPi, quick_sum(fraction.high, fraction.low))};
}

constexpr double kNoTurn = 0.78;  // below, an angle is its own rest

Quarters quarters_of(double x) {
  constexpr double kFewTurns = 1e6;
  if (std::fabs(x) < kNoTurn) return {0, {x, 0}};
  if (std::fabs(x) < kFewTurns) return take_parts(x);
  Quarters turned = multiply_out(std::fabs(x));
  if (x > 0) return turned;
  return {(4 - turned.count) & 3U, minus(turned.rest)};
}

// Below a quarter the cube is small beside x: one rounding of it hardly matters.
constexpr double kSeriesEnd = 0.25;

// sin(x) - x for |x| <= kSeriesEnd: x^3 (-1/3! + x^2/5! - …).
double sine_rest(double x) {
  const double s = x * x;
  return s * x *
         (-1.0 / 6 +
          s * (1.0 / 120 +
               s * (-1.0 / 5040 + s * (1.0 / 362880 + s * (-1.0 / 39916800 + s / 6227020800.0)))));
}

// cos(x) - 1 + x^2/2 for |x| <= kSeriesEnd.
double cosine_rest(double x) {
  const double s = x * x;
  return s * s *
         (1.0 / 24 +
          s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800 +
                                                    s * (1.0 / 479001600 - s / 87178291200.0)))));
}

// Sine and cosine of a rest, as sums of two doubles.

Pair sine_near_zero(Pair x) {
  return quick_sum(x.high, sine_rest(x.high) + x.low * (1 - x.high * x.high / 2));
}

Pair cosine_near_zero(Pair x) {
  const Pair half = square(x.high);
  const Pair whole = quick_sum(1, -half.high / 2);
  return quick_sum(whole.high, whole.low + (cosine_rest(x.high) - half.low / 2 - x.high * x.low));
}

// An angle in [0, pi/4] as k/64 and what is left, with sin(rest) - rest and 1 - cos(rest).
struct Entry {
  explicit Entry(Pair x)
      : k(static_cast<std::size_t>(x.high * 64 + 0.5)),
        d(x.high - static_cast<double>(k) / 64),
        sine(sine_rest(d) + x.low),
        versed(d * d / 2 - cosine_rest(d) + d * x.low) {}

  std::size_t k;
  double d;
  double sine;
  double versed;
};

// By the sums of angles: sin = S + C d + (C (sin d - d) - S (1 - cos d)), cos likewise. What is
// added to S and C is at most 1/128 of 1, and they are above 0.24: its roundings hardly matter.

Pair sine_near_entry(const Entry& at) {
  const Pair s = kSines[at.k];
  const Pair c = kCosines[at.k];
  const Pair whole = quick_sum(s.high, c.high * at.d);
  return quick_sum(whole.high,
                   whole.low + (s.low + c.low * at.d + c.high * at.sine - s.high * at.versed));
}

Pair cosine_near_entry(const Entry& at) {
  const Pair s = kSines[at.k];
  const Pair c = kCosines[at.k];
  const Pair whole = quick_sum(c.high, -s.high * at.d);
  return quick_sum(whole.high,
                   whole.low + (c.low - s.low * at.d - s.high * at.sine - c.high * at.versed));
}

Pair sine_of_rest(Pair x) {
  if (std::fabs(x.high) <= kSeriesEnd) return sine_near_zero(x);
  return x.high < 0 ? minus(sine_near_entry(Entry(minus(x)))) : sine_near_entry(Entry(x));
}

Pair cosine_of_rest(Pair x) {
  if (std::fabs(x.high) <= kSeriesEnd) return cosine_near_zero(x);
  return cosine_near_entry(Entry(x.high < 0 ? minus(x) : x));
}

Pair sine_of(const Quarters& angle) {
  const Pair value = (angle.count & 1) != 0 ? cosine_of_rest(angle.rest) : sine_of_rest(angle.rest);
  return (angle.count & 2) != 0 ? minus(value) : value;
}

Pair cosine_of(const Quarters& angle) {
  const Pair value = (angle.count & 1) != 0 ? sine_of_rest(angle.rest) : cosine_of_rest(angle.rest);
  return ((angle.count + 1) & 2) != 0 ? minus(value) : value;
}

// atan(n/d) for n in [0, d], d > 0: with c = k/64 near n/d it is atan(c) + atan((n - cd)/(d + cn)).
Pair arctangent_of_share(Pair n, Pair d) {
  const auto k = static_cast<std::size_t>(n.high / d.high * 64 + 0.5);
  const double c = static_cast<double>(k) / 64;
  const Pair t = k == 0 ? quotient(n, d) : quotient(sum(n, product(d, -c)), sum(d, product(n, c)));
  const double s = t.high * t.high;
  const double rest =
      s * t.high * (-1.0 / 3 + s * (1.0 / 5 + s * (-1.0 / 7 + s * (1.0 / 9 - s / 11))));
  const Pair entry = kArctangents[k];
  const Pair whole = sum(entry.high, t.high);
  return quick_sum(whole.high, whole.low + (t.low + (entry.low + rest)));
}

// The angle of a point with x, y >= 0, not both 0, of sizes whose quotient is no worry.
Pair angle_in_first_quarter(Pair y, Pair x) {
  if (y.high <= x.high) return arctangent_of_share(y, x);
  return sum(kHalfPi, minus(arctangent_of_share(x, y)));
}

}  // namespace

// Angles without a turn go straight to the series: a third of the time, and the same bits.

double sin(double angle_rad) {
  if (!std::isfinite(angle_rad)) return kNan;
  if (std::fabs(angle_rad) < kOwnSine) return angle_rad;
  if (std::fabs(angle_rad) < kNoTurn) return rounded(sine_of_rest({angle_rad, 0}));
  return rounded(sine_of(quarters_of(angle_rad)));
}

double cos(double angle_rad) {
  if (!std::isfinite(angle_rad)) return kNan;
  if (std::fabs(angle_rad) < kNoTurn) return rounded(cosine_of_rest({angle_rad, 0}));
  return rounded(cosine_of(quarters_of(angle_rad)));
}

SineCosine sine_cosine(double angle_rad) {
  if (!(std::fabs(angle_rad) >= kOwnSine && std::isfinite(angle_rad)))
    return {sin(angle_rad), cos(angle_rad)};
  const Quarters angle = quarters_of(angle_rad);
  return {rounded(sine_of(angle)), rounded(cosine_of(angle))};
}

double tan(double angle_rad) {
  if (!std::isfinite(angle_rad)) return kNan;
  if (std::fabs(angle_rad) < kOwnSine) return angle_rad;
  const Quarters angle = quarters_of(angle_rad);
  return rounded(quotient(sine_of(angle), cosine_of(angle)));
}

double atan(double x) {
  if (std::isnan(x)) return x;
  if (std::fabs(x) < kOwnSine) return x;
  if (std::fabs(x) > 0x1p60) return std::copysign(kHalfPi.high, x);
  return std::copysign(rounded(angle_in_first_quarter({std::fabs(x), 0}, {1, 0})), x);
}

namespace {

// Where neither can be lost in a product, and the smaller one matters.
bool are_moderate(double up, double right) {
  constexpr double kLargeSide = 0x1p400;
  constexpr double kSmallSide = 0x1p-400;
  constexpr double kFar = 0x1p60;
  return up < kLargeSide && right < kLargeSide && up > kSmallSide && right > kSmallSide &&
         up < kFar * right && right < kFar * up;
}

// x, y >= 0 of any size; where one is far larger than the other its angle is that of the axis.
Pair angle_of_any(double up, double right) {
  if (std::isinf(up) && std::isinf(right)) return angle_in_first_quarter({1, 0}, {1, 0});
  if (up == 0 || std::isinf(right)) return {};
  if (right == 0 || std::isinf(up)) return kHalfPi;
  int up_exponent = 0;
  int right_exponent = 0;
  up = std::frexp(up, &up_exponent);
  right = std::frexp(right, &right_exponent);
  const int lead = up_exponent - right_exponent;
  if (lead > 60) return kHalfPi;
  if (lead < -60) return {std::ldexp(up / right, lead), 0};
  return angle_in_first_quarter({std::ldexp(up, lead), 0}, {right, 0});
}

}  // namespace

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNan;
  const double up = std::fabs(y);
  const double right = std::fabs(x);
  const Pair angle = are_moderate(up, right) ? angle_in_first_quarter({up, 0}, {right, 0})
                                             : angle_of_any(up, right);
  return std::copysign(rounded(std::signbit(x) ? sum(kPi, minus(angle)) : angle), y);
}

namespace {

// sqrt((1 - x)(1 + x)) for x in [0, 1].
Pair other_leg(double x) {
  const Pair square_of_it = product(sum(1, x), 1 - x);
  // 1 - x is exact above 1/2; below, what it lost counts.
  const Pair lost = sum(1, -x);
  const Pair whole = sum(square_of_it, lost.low * (1 + x));
  if (whole.high <= 0) return {};
  const double root = std::sqrt(whole.high);
  const Pair back = square(root);
  return quick_sum(root, ((whole.high - back.high) - back.low + whole.low) / (2 * root));
}

}  // namespace

double asin(double x) {
  if (!(std::fabs(x) <= 1)) return kNan;
  if (std::fabs(x) < kOwnSine) return x;
  const double size = std::fabs(x);
  return std::copysign(rounded(angle_in_first_quarter({size, 0}, other_leg(size))), x);
}

double acos(double x) {
  if (!(std::fabs(x) <= 1)) return kNan;
  const double size = std::fabs(x);
  const Pair angle = angle_in_first_quarter(other_leg(size), {size, 0});
  return rounded(x < 0 ? sum(kPi, minus(angle)) : angle);
}

}  // namespace kerf::math
