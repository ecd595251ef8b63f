#include "base/decimal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>

namespace kerf::base {
namespace {

constexpr int kDoubles = 1'500'000;
constexpr std::uint64_t kSeed = 20260101;

double random_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

// A number as a program writes it: up to 9 digits, up to 8 of them behind the point.
double random_decimal(std::mt19937_64& random) {
  const auto digits = static_cast<std::int64_t>(random() % 2'000'000'000) - 1'000'000'000;
  double divisor = 1;
  for (auto places = random() % 9; places > 0; --places) divisor *= 10;
  return static_cast<double>(digits) / divisor;
}

// The digits of a number's text that count: no sign, point, exponent, or zeros at its ends.
std::string significant_digits(std::string_view text) {
  std::string digits;
  for (const char c : text.substr(0, text.find_first_of("eE"))) {
    if (c >= '0' && c <= '9') digits += c;
  }
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits;
}

// The library's own shortest text: of the plain and the scientific form the one with fewer
// characters.
std::string shortest_text(double value) {
  std::array<char, 64> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string shortest_digits(double value) {
  std::array<char, 64> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
  return significant_digits({text.data(), end.ptr});
}

// number = [-] ( 0 | 1-9 digits ) [ . digits ] [ e [+|-] digits ]
bool is_json_number(std::string_view text) {
  const auto digits = [&] {
    std::size_t count = 0;
    while (count < text.size() && text[count] >= '0' && text[count] <= '9') ++count;
    text.remove_prefix(count);
    return count;
  };
  if (text.starts_with('-')) text.remove_prefix(1);
  const bool zero = text.starts_with('0');
  const std::size_t whole = digits();
  if (whole == 0 || (zero && whole > 1)) return false;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    if (digits() == 0) return false;
  }
  if (text.starts_with('e')) {
    text.remove_prefix(1);
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    if (digits() == 0) return false;
  }
  return text.empty();
}

// False with a failure when the text of `value` is not what it should be.
bool prints_well(double value) {
  const std::string text = number_text(value);
  double back = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), back);
  const bool reads_back = error == std::errc() && end == text.data() + text.size() && back == value;
  const bool shortest =
      text == shortest_text(value) || significant_digits(text) == shortest_digits(value);
  if (reads_back && shortest && is_json_number(text)) return true;
  ADD_FAILURE() << "the double " << std::hexfloat << value << " prints as " << text
                << (reads_back ? "" : ", which reads back as another double")
                << (shortest ? "" : ", shortest are the digits ")
                << (shortest ? "" : shortest_digits(value))
                << (is_json_number(text) ? "" : ", which is no JSON number");
  return false;
}

TEST(Decimal, AnyDoublePrintsWithTheFewestDigitsThatReadBack) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < kDoubles; ++i) {
    if (!prints_well(random_double(random))) return;
  }
}

TEST(Decimal, AnyDecimalPrintsWithTheFewestDigitsThatReadBack) {
  std::mt19937_64 random(kSeed + 1);
  for (int i = 0; i < kDoubles; ++i) {
    if (!prints_well(random_decimal(random))) return;
  }
}

TEST(Decimal, NeighboursOfDecimalsPrintWithTheFewestDigitsThatReadBack) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::mt19937_64 random(kSeed + 2);
  for (int i = 0; i < kDoubles / 4; ++i) {
    const double value = random_decimal(random);
    if (!prints_well(std::nextafter(value, kInfinity))) return;
    if (!prints_well(std::nextafter(value, -kInfinity))) return;
  }
}

TEST(Decimal, EdgesOfTheShortWayPrintAsAllOthers) {
  for (const double value : {1e9, 999999999.99999, 1e14 / 1e5, 123456789.12345, 1e15, 1e16, 1e21,
                             0.00001, 0.000001, 5e-324, 1.7976931348623157e308, 2.5e-5, 1e-5,
                             99999.99999, 4503599627370497.5, 9007199254740993.0}) {
    EXPECT_TRUE(prints_well(value));
    EXPECT_TRUE(prints_well(-value));
  }
}

TEST(Decimal, NumbersOfProgramsPrintAsAPersonWouldWriteThem) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(10), "10");
  EXPECT_EQ(number_text(-0.5), "-0.5");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(123.456), "123.456");
  EXPECT_EQ(number_text(99999.999), "99999.999");
  EXPECT_EQ(number_text(-0.00001), "-0.00001");
}

TEST(Decimal, MinusZeroPrintsAsZero) { EXPECT_EQ(number_text(-0.0), "0"); }

TEST(Decimal, WhatIsNotFinitePrintsAsNull) {
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "null");
}

TEST(Decimal, AppendKeepsWhatStandsBefore) {
  std::string text = "X";
  append_number(text, 1.5);
  append_number(text, -2);
  EXPECT_EQ(text, "X1.5-2");
}

TEST(Tidy, AMultipleOfAHundredThousandthStaysTheDoubleNearestToIt) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < kDoubles; ++i) {
    const auto units =
        static_cast<std::int64_t>(random() % 20'000'000'000'000) - 10'000'000'000'000;
    const double value = static_cast<double>(units) / 1e5;
    ASSERT_EQ(tidy(value), value) << units << " hundred-thousandths, seed " << kSeed;
  }
}

TEST(Tidy, AValueWithinANanometreBecomesTheMultiple) {
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> off(-0.9e-9, 0.9e-9);
  for (int i = 0; i < kDoubles; ++i) {
    const auto units = static_cast<std::int64_t>(random() % 20'000'000'000) - 10'000'000'000;
    const double value = static_cast<double>(units) / 1e5;
    ASSERT_EQ(tidy(value + off(random)), value) << units << " hundred-thousandths, seed " << kSeed;
  }
}

TEST(Tidy, AValueFurtherAwayStaysAsItIs) {
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> off(1.1e-9, 5e-6 - 1.1e-9);
  for (int i = 0; i < kDoubles; ++i) {
    const auto units = static_cast<std::int64_t>(random() % 200'000'000) - 100'000'000;
    const double sign = (random() & 1) != 0 ? 1 : -1;
    const double value = static_cast<double>(units) / 1e5 + sign * off(random);
    ASSERT_EQ(tidy(value), value) << "seed " << kSeed;
  }
}

TEST(Tidy, TidyingTwiceChangesNothing) {
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> values(-1e6, 1e6);
  for (int i = 0; i < kDoubles; ++i) {
    const double once = tidy(values(random));
    ASSERT_EQ(tidy(once), once);
  }
}

TEST(Tidy, SumsOfWordsNeverDrift) {
  std::mt19937_64 random(kSeed);
  for (int run = 0; run < 200; ++run) {
    std::int64_t exact = 0;  // in 0.00001 mm
    double sum = 0;
    for (int i = 0; i < 5000; ++i) {
      // least increments: 0.001 mm, or 0.0001 inch = 0.00254 mm
      const std::int64_t step =
          (static_cast<std::int64_t>(random() % 2001) - 1000) * ((random() & 1) != 0 ? 100 : 254);
      exact += step;
      sum = tidy(sum + static_cast<double>(step) / 1e5);
      ASSERT_EQ(sum, static_cast<double>(exact) / 1e5) << "run " << run << ", step " << i;
    }
  }
}

TEST(Tidy, MinusZeroBecomesZero) {
  EXPECT_FALSE(std::signbit(tidy(-0.0)));
  EXPECT_FALSE(std::signbit(tidy(-1e-10)));
}

TEST(Tidy, HugeValuesAndWhatIsNotFiniteStayAsTheyAre) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : {1e10, 1e15, 1e300, -1e10, 12345678901.123457, kInfinity, -kInfinity}) {
    EXPECT_EQ(tidy(value), value);
  }
  EXPECT_TRUE(std::isnan(tidy(std::numeric_limits<double>::quiet_NaN())));
}

TEST(RoundAway, TiesGoAwayFromZero) {
  EXPECT_EQ(round_away(0.5), 1);
  EXPECT_EQ(round_away(-0.5), -1);
  EXPECT_EQ(round_away(2.5), 3);
  EXPECT_EQ(round_away(-2.5), -3);
  EXPECT_EQ(round_away(0), 0);
}

TEST(RoundAway, EverythingElseGoesToTheNearestInteger) {
  for (const double value :
       {0.4, 0.49999999999999994, 0.6, 1.4999999999999998, 1e6 + 0.25, 4503599627370495.5,
        4503599627370497.0, 9007199254740991.0, -0.49999999999999994, -4503599627370497.0}) {
    EXPECT_EQ(static_cast<double>(round_away(value)), std::round(value))
        << "of " << number_text(value);
  }
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < kDoubles / 4; ++i) {
    const double value = random_decimal(random);
    ASSERT_EQ(static_cast<double>(round_away(value)), std::round(value)) << number_text(value);
  }
}

TEST(RoundAway, WhatNoIntegerHoldsBecomesTheLargest) {
  constexpr std::int64_t kMost = std::int64_t{1} << 62;
  EXPECT_EQ(round_away(1e300), kMost);
  EXPECT_EQ(round_away(-1e300), -kMost);
  EXPECT_EQ(round_away(std::numeric_limits<double>::infinity()), kMost);
  EXPECT_EQ(round_away(-std::numeric_limits<double>::infinity()), -kMost);
}

TEST(AppendInteger, WritesEveryDigitAndTheSign) {
  std::string text = "at ";
  append_integer(text, 0);
  append_integer(text, std::numeric_limits<std::int64_t>::min());
  append_integer(text, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(text, "at 0-92233720368547758089223372036854775807");
}

TEST(DecimalOf, IsTheDecimalThatTheFloatWasRoundedFrom) {
  EXPECT_EQ(decimal_of(33.3F), 33.3);
  EXPECT_EQ(decimal_of(80), 80);
  EXPECT_EQ(decimal_of(0.1F), 0.1);
  EXPECT_EQ(decimal_of(-12.5F), -12.5);
  EXPECT_EQ(decimal_of(0), 0);
}

}  // namespace
}  // namespace kerf::base
