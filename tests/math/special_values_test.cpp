// What math/math.hpp promises besides accuracy: values without a neighbour to round to, and the
// same bits from every compiler, processor and C library.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "math/math.hpp"

namespace kerf::math {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kMost = std::numeric_limits<double>::max();

// The C library knows all of ISO C, annex F.
template <typename Ours, typename Theirs>
void expect_as_annex_f(const char* name, Ours ours, Theirs theirs) {
  for (const double x :
       {0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, kInf, -kInf, kNan, 3.0, -3.0}) {
    const double a = ours(x);
    const double b = theirs(x);
    if (std::isnan(b)) {
      EXPECT_TRUE(std::isnan(a)) << name << '(' << x << ')';
    } else {
      EXPECT_TRUE(a == b || std::fabs(a - b) <= 1e-15 * std::fabs(b))
          << name << '(' << x << "): " << a << ", not " << b;
      EXPECT_EQ(std::signbit(a), std::signbit(b)) << name << '(' << x << ')';
    }
  }
}

#define EXPECT_ANNEX_F(function) \
  expect_as_annex_f(             \
      #function, [](double x) { return function(x); }, [](double x) { return std::function(x); })

TEST(MathSpecialValues, FunctionsOfOneNumberFollowAnnexF) {
  EXPECT_ANNEX_F(sin);
  EXPECT_ANNEX_F(cos);
  EXPECT_ANNEX_F(tan);
  EXPECT_ANNEX_F(asin);
  EXPECT_ANNEX_F(acos);
  EXPECT_ANNEX_F(atan);
  EXPECT_ANNEX_F(exp);
  EXPECT_ANNEX_F(log);
  EXPECT_ANNEX_F(log2);
  EXPECT_ANNEX_F(log10);
  EXPECT_ANNEX_F(cbrt);
}

TEST(MathSpecialValues, FunctionsOfTwoNumbersFollowAnnexF) {
  const double values[] = {0.0, -0.0, 1.0,   -1.0, 2.0,   -2.0, 0.5,   -0.5,   3.0,
                           -3., kInf, -kInf, kNan, 1e300, -1e9, kTiny, -kTiny, kMost};
  for (const double y : values) {
    expect_as_annex_f(
        "atan2", [y](double x) { return atan2(y, x); }, [y](double x) { return std::atan2(y, x); });
    expect_as_annex_f(
        "hypot", [y](double x) { return hypot(x, y); }, [y](double x) { return std::hypot(x, y); });
    expect_as_annex_f(
        "pow", [y](double x) { return pow(x, y); }, [y](double x) { return std::pow(x, y); });
    expect_as_annex_f(
        "pow", [y](double x) { return pow(y, x); }, [y](double x) { return std::pow(y, x); });
  }
}

TEST(MathSpecialValues, APowerThatIsADoubleIsExact) {
  for (int base = 2; base <= 100; ++base) {
    double product = 1;
    for (int n = 1; product * base < 0x1p53; ++n) {
      product *= base;
      EXPECT_EQ(pow(base, n), product) << base << '^' << n;
      EXPECT_EQ(pow(-base, n), n % 2 == 0 ? product : -product) << base << '^' << n;
    }
  }
  for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(pow(2, n), std::ldexp(1, n)) << n;
  for (int n = -1074; n <= 1023; ++n) EXPECT_EQ(log2(std::ldexp(1, n)), n);
  for (int n = 0; n <= 22; ++n) EXPECT_EQ(log10(pow(10, n)), n);
}

TEST(MathSpecialValues, SquaresAndCubesHaveExactRoots) {
  for (int i = 1; i <= 2000; ++i) {
    const double n = i;
    EXPECT_EQ(cbrt(n * n * n), n);
    EXPECT_EQ(hypot(3 * n, 4 * n), 5 * n);
    EXPECT_EQ(hypot(n, 0), n);
    EXPECT_EQ(hypot(n, 2 * n, 2 * n), 3 * n);
  }
}

TEST(MathSpecialValues, BothAreTheSameBitsAsAlone) {
  std::mt19937_64 engine(20260101);
  for (int i = 0; i < 100000; ++i) {
    const double angle = static_cast<double>(static_cast<std::int64_t>(engine())) * 0x1p-50;
    const SineCosine both = sine_cosine(angle);
    EXPECT_EQ(both.sine, sin(angle));
    EXPECT_EQ(both.cosine, cos(angle));
  }
}

// Every bit of some 200,000 results. Another number here means other bits of outputs on other
// computers; a change of the functions changes it, and the bytes of many outputs.
TEST(MathSpecialValues, TheBitsAreTheSameEverywhere) {
  std::mt19937_64 engine(20260101);
  std::uint64_t fingerprint = 0;
  const auto add = [&](double result) {
    fingerprint = (fingerprint ^ std::bit_cast<std::uint64_t>(result)) * 0x100000001B3ULL;
  };
  for (int i = 0; i < 10000; ++i) {
    const double x = static_cast<double>(static_cast<std::int64_t>(engine())) * 0x1p-57;
    const double y = static_cast<double>(static_cast<std::int64_t>(engine())) * 0x1p-53;
    for (const double angle : {x, x * 0x1p-9, x * 0x1p30}) {
      add(sin(angle));
      add(cos(angle));
      add(tan(angle));
      add(atan(angle));
      add(cbrt(angle));
    }
    add(asin(x / 64));
    add(acos(x / 64));
    add(exp(x));
    add(log(std::fabs(x)));
    add(pow(std::fabs(x), y / 512));
    add(atan2(x, y));
    add(hypot(x, y));
    add(hypot(x, y, x - y));
  }
  EXPECT_EQ(fingerprint, 16831015254577013619ULL);
}

}  // namespace
}  // namespace kerf::math
