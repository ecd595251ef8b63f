#pragma once

#include <cfloat>
#include <limits>

namespace kerf::math {

static_assert(FLT_EVAL_METHOD == 0 && std::numeric_limits<double>::is_iec559,
              "the bits of all results follow from doubles that are rounded once");
#ifdef __FAST_MATH__
#error "-ffast-math reorders the sums that all of this rests on"
#endif

/// The exact sum of two doubles, high + low: some 106 bits. `low` is at most half of the last digit
/// of `high` where not said otherwise.
///
/// Needs sums and products of doubles that are rounded once, to nearest: no fused operations
/// (-ffp-contract=off), no wider registers.
struct Pair {
  double high = 0;
  double low = 0;
};

constexpr double rounded(Pair x) { return x.high + x.low; }

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Of |a| >= |b|, or a = 0 (Dekker 1971). Exact.
constexpr Pair quick_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Exact (Knuth, The Art of Computer Programming 2, 4.2.2).
constexpr Pair sum(double a, double b) {
  const double whole = a + b;
  const double of_b = whole - a;
  return {whole, (a - (whole - of_b)) + (b - of_b)};
}

/// A double as two of 26 bits (Veltkamp). Of |a| < 2^996.
constexpr Pair halves(double a) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double scaled = kSplitter * a;
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// Exact where nothing of it is below 2^-1074 (Dekker 1971).
constexpr Pair product(double a, double b) {
  const double whole = a * b;
  const Pair x = halves(a);
  const Pair y = halves(b);
  return {whole, ((x.high * y.high - whole) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

constexpr Pair square(double a) {
  const double whole = a * a;
  const Pair x = halves(a);
  return {whole, ((x.high * x.high - whole) + 2 * (x.high * x.low)) + x.low * x.low};
}

/// Ties to even; of |a| < 2^51.
constexpr double nearest_integer(double a) {
  constexpr double kWholeFromHere = 0x1.8p52;
  return (a + kWholeFromHere) - kWholeFromHere;
}

// From here on: a relative error of a few 2^-104.

constexpr Pair sum(Pair a, double b) {
  const Pair high = sum(a.high, b);
  return quick_sum(high.high, high.low + a.low);
}

constexpr Pair sum(Pair a, Pair b) {
  const Pair high = sum(a.high, b.high);
  const Pair low = sum(a.low, b.low);
  const Pair first = quick_sum(high.high, high.low + low.high);
  return quick_sum(first.high, first.low + low.low);
}

constexpr Pair minus(Pair a) { return {-a.high, -a.low}; }

constexpr Pair product(Pair a, double b) {
  const Pair high = product(a.high, b);
  return quick_sum(high.high, high.low + a.low * b);
}

constexpr Pair product(Pair a, Pair b) {
  const Pair high = product(a.high, b.high);
  return quick_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

constexpr Pair quotient(Pair a, Pair b) {
  const double first = a.high / b.high;
  const Pair back = product(b, first);
  const double rest = ((a.high - back.high) - back.low) + a.low;
  return quick_sum(first, rest / b.high);
}

}  // namespace kerf::math
