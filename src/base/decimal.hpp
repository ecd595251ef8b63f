#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kerf::base {

/// Text of numbers, read and written here alone (tools/check_rooms.py): the same everywhere,
/// whatever the locale, the C library and the length of its types are.

/// `value` rounded to the nearest integer, ties away from zero; beyond ±2^62 that number.
inline std::int64_t round_away(double value) {
  constexpr double kMost = 4611686018427387904.0;
  if (!(value < kMost)) return std::int64_t{1} << 62;
  if (value < -kMost) return -(std::int64_t{1} << 62);
  // What is left behind the integer part is exact; value + 0.5 would not be.
  const auto whole = static_cast<std::int64_t>(value);
  const double rest = value - static_cast<double>(whole);
  return whole + static_cast<std::int64_t>(rest >= 0.5) - static_cast<std::int64_t>(rest <= -0.5);
}

/// Coordinates are sums of decimal words, but doubles hold no decimals: 0.1 + 0.2 is not 0.3. A
/// value within 1e-9 of a multiple of 1e-5 (mm or degree; 1e-5 mm divides both 0.001 mm and 0.0001
/// inch) becomes the double nearest to that multiple; every other value stays as it is. So sums of
/// words never drift and print as a person would write them.
inline double tidy(double value) {
  const double scaled = value * 1e5;
  if (!(scaled < 1e15 && scaled > -1e15)) return value;
  const auto nearest = static_cast<double>(round_away(scaled));
  const double off = scaled - nearest;
  return off < 1e-4 && off > -1e-4 ? nearest / 1e5 + 0.0 : value;
}

/// Appends the fewest digits that read back to the same double; -0 is 0, and what is not finite
/// (which no result of Kerf is) prints as null, as JSON has no word for it.
void append_number(std::string& out, double value);

[[nodiscard]] std::string number_text(double value);

/// The same digits, but never with an exponent.
void append_decimal(std::string& out, double value);

/// Finite `value` rounded to `decimals` (0 to 20) behind the point, ties of the double to even,
/// without zeros at the end; -0 is 0.
[[nodiscard]] std::string rounded_text(double value, int decimals);

void append_integer(std::string& out, std::int64_t value);

enum class NumberFault : std::uint8_t { no_number, too_large };

/// The double nearest to the number that is all of `text`: [+|-] digits, perhaps with one point
/// among them, and perhaps e [+|-] digits. What is too small for a double is 0.
[[nodiscard]] tl::expected<double, NumberFault> read_number(std::string_view text);

/// The number that is all of `text`: digits, no sign.
[[nodiscard]] tl::expected<std::uint64_t, NumberFault> read_whole_number(std::string_view text);

/// The double nearest to the fewest digits that read back to `value`: 33.3F is 33.3, not
/// 33.29999923706055.
[[nodiscard]] double decimal_of(float value);

}  // namespace kerf::base
