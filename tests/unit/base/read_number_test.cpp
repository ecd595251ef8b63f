// Numbers are read in one way, whatever the language, the locale and the C library are.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>
#include <random>
#include <string>

#include "base/decimal.hpp"
#include "face/cli/arguments.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::base {
namespace {

constexpr std::uint64_t kSeed = 20260101;

std::string zeros(std::size_t count) { return std::string(count, '0'); }

TEST(ReadNumber, TakesWhatPeopleAndProgramsWrite) {
  const std::pair<std::string, double> cases[] = {
      {"0", 0},           {"-0", 0},      {"7", 7},        {"+7", 7},         {"-7", -7},
      {"007", 7},         {"12.5", 12.5}, {"12.", 12},     {".5", 0.5},       {"-.5", -0.5},
      {"+.5", 0.5},       {"1e3", 1000},  {"1E3", 1000},   {"1e+3", 1000},    {"1e-3", 0.001},
      {"1.5e-3", 1.5e-3}, {"1.e2", 100},  {"0e999999", 0}, {"5e-324", 5e-324}};
  for (const auto& [text, value] : cases) {
    const auto read = read_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, value) << text;
  }
}

TEST(ReadNumber, TakesNothingElse) {
  for (const std::string_view text :
       {"",      ".",     "+",    "-",        "+-5",     "-+5",         "--5",   "++5",    "+.",
        "-.",    " 5",    "5 ",   "1e",       "1e+",     "e5",          "5e5e5", "1.2.3",  "0x10",
        "inf",   "-inf",  "+inf", "infinity", "nan",     "-nan",        "+nan",  "nan(1)", "1,5",
        "1'000", "1_000", "5mm",  "1e400x",   "1e-400x", "\xEF\xBC\x95"}) {
    const auto read = read_number(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error(), NumberFault::no_number) << text;
  }
}

TEST(ReadNumber, WhatIsTooSmallForADoubleIsZero) {
  for (const std::string& text :
       {std::string("1e-400"), std::string("-1e-400"), std::string("2e-324"),
        std::string("0.00001e-320"), std::string("1e-99999999999999999999"), "." + zeros(400) + "1",
        "-0." + zeros(400) + "1", "0." + zeros(400) + "1e5", "1" + zeros(50) + "e-400"}) {
    const auto read = read_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, 0) << text;
  }
}

TEST(ReadNumber, WhatIsTooLargeForADoubleIsSaidSo) {
  for (const std::string& text :
       {std::string("1e400"), std::string("-1e400"), std::string("1.8e308"), "1" + zeros(400),
        std::string("1e99999999999999999999"), std::string("+1e+400"), "1" + zeros(400) + "e-50",
        "0." + zeros(50) + "1e400", zeros(400) + "1e400"}) {
    const auto read = read_number(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error(), NumberFault::too_large) << text;
  }
}

TEST(ReadNumber, ManyZerosMakeANumberNeitherLargeNorSmall) {
  EXPECT_EQ(read_number(zeros(400) + "1"), 1.0);
  EXPECT_EQ(read_number("1." + zeros(400)), 1.0);
  EXPECT_EQ(read_number("1" + zeros(400) + "e-400"), 1.0);
  EXPECT_EQ(read_number("0." + zeros(399) + "1e400"), 1.0);
}

// The other way: the C library's, which rounds to nearest in the locale "C".
TEST(ReadNumber, RoundsToTheNearestDouble) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 300'000; ++i) {
    std::string text(random() % 2, '-');
    for (auto digits = 1 + random() % 25; digits > 0; --digits)
      text += static_cast<char>('0' + random() % 10);
    text += '.';
    for (auto digits = random() % 25; digits > 0; --digits)
      text += static_cast<char>('0' + random() % 10);
    if (random() % 2 == 0) text += "e" + std::to_string(static_cast<int>(random() % 500) - 250);
    const auto read = read_number(text);
    ASSERT_TRUE(read) << text << ", seed " << kSeed;
    ASSERT_EQ(*read, std::strtod(text.c_str(), nullptr)) << text << ", seed " << kSeed;
  }
}

TEST(ReadNumber, ReadsBackEveryDoubleThatIsWritten) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 300'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    std::string plain;
    append_decimal(plain, value);
    ASSERT_EQ(read_number(number_text(value)), value) << number_text(value);
    ASSERT_EQ(read_number(plain), value) << plain;
    ASSERT_EQ(plain.find_first_of("eE"), std::string::npos) << plain;
  }
}

TEST(ReadWholeNumber, TakesDigitsAlone) {
  EXPECT_EQ(read_whole_number("0"), 0U);
  EXPECT_EQ(read_whole_number("0042"), 42U);
  EXPECT_EQ(read_whole_number("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(read_whole_number("18446744073709551616").error(), NumberFault::too_large);
  for (const std::string_view text : {"", "+1", "-1", " 1", "1 ", "1.", "1e1", "x", "0x1"})
    EXPECT_EQ(read_whole_number(text).error(), NumberFault::no_number) << text;
}

TEST(RoundedText, HasTheDecimalsThatAreAskedForAndNoZerosBehindThem) {
  EXPECT_EQ(rounded_text(1.5, 3), "1.5");
  EXPECT_EQ(rounded_text(-0.0001, 3), "0");
  EXPECT_EQ(rounded_text(100, 0), "100");
  EXPECT_EQ(rounded_text(33.33333, 3), "33.333");
  EXPECT_EQ(rounded_text(0.125, 2), "0.12");
  EXPECT_EQ(rounded_text(-1e21, 2), "-1000000000000000000000");
}

// As in many countries: 1.234.567,5.
class CommaForPoint : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class GlobalLocale {
 public:
  explicit GlobalLocale(const std::locale& now) : before_(std::locale::global(now)) {}
  ~GlobalLocale() { std::locale::global(before_); }
  GlobalLocale(const GlobalLocale&) = delete;
  GlobalLocale& operator=(const GlobalLocale&) = delete;

 private:
  std::locale before_;
};

double acceleration_of_x() {
  const auto machine = machine::MachineDefinition::parse(
      "name = 'm'\n[[axis]]\nname = 'X'\nvelocity = 1000\nacceleration = 1234.5\n", "m.toml");
  return machine ? machine->axes.axes.front().acceleration : 0;
}

TEST(Numbers, AreTheSameInEveryLocale) {
  const GlobalLocale comma(std::locale(std::locale::classic(), new CommaForPoint));
  EXPECT_EQ(number_text(1234567.5), "1234567.5");
  EXPECT_EQ(rounded_text(1234567.25, 1), "1234567.2");
  EXPECT_EQ(read_number("1234567.5"), 1234567.5);
  EXPECT_FALSE(read_number("1.234.567,5"));
  EXPECT_EQ(acceleration_of_x(), 1234.5);
}

// Between 1 and the next double, a little above the middle: whoever rounds to a longer type first
// comes to the middle itself, and from there to 1.
TEST(Numbers, OfOptionsAreRoundedOnce) {
  const std::string above_middle = "1.00000000000000011102230246251565404236316680908203126";
  const auto request =
      cli::parse_arguments({"run", "part.nc", "--max-seconds", above_middle, "--interrupt-at",
                            "2.5", "--interrupt-at", above_middle});
  ASSERT_TRUE(request);
  const auto& options = std::get<cli::RunOptions>(*request);
  EXPECT_EQ(options.max_seconds, std::nextafter(1, 2));
  EXPECT_EQ(options.interrupt_at, (std::vector<double>{2.5, std::nextafter(1, 2)}));
}

}  // namespace
}  // namespace kerf::base
