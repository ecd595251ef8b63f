#include "base/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace kerf::base {
namespace {

// A decimal of at most 15 digits that reads back to `value` is the shortest one: no two of them
// read as the same double. Nearly all coordinates have at most five decimals, which makes this
// worth it.
bool append_short_decimal(std::string& out, double value) {
  const double scaled = value * 1e5;
  if (!(scaled < 1e14 && scaled > -1e14)) return false;
  const std::int64_t units = round_away(scaled);
  if (static_cast<double>(units) / 1e5 != value) return false;
  std::array<char, 24> digits;
  char* const end = digits.data() + digits.size();
  char* at = end;
  auto rest = static_cast<std::uint64_t>(units < 0 ? -units : units);
  std::uint64_t fraction = rest % 100000;
  rest /= 100000;
  if (fraction != 0) {
    int places = 5;
    for (; fraction % 10 == 0; fraction /= 10) --places;
    for (; places > 0; --places, fraction /= 10) *--at = static_cast<char>('0' + fraction % 10);
    *--at = '.';
  }
  do {
    *--at = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  if (units < 0) *--at = '-';
  out.append(at, end);
  return true;
}

// Of a number that is beyond the doubles: std::from_chars does not say on which side. The place of
// its first digit does, which is 0 for 0.1, 1 for 1 and 2 for 10.
bool is_below_one(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), e);
  const std::size_t first = text.find_first_of("123456789");
  const auto distance = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  const std::int64_t place = first < point ? distance : distance + 1;
  if (e == text.size()) return place <= 0;
  std::string_view exponent = text.substr(e + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int32_t shift = 0;
  const auto read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), shift);
  return read.ec == std::errc() ? place + shift <= 0 : exponent.starts_with('-');
}

tl::unexpected<NumberFault> wrong(NumberFault fault) { return tl::unexpected(fault); }

}  // namespace

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  if (append_short_decimal(out, value)) return;
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end);
}

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_decimal(std::string& out, double value) {
  std::array<char, 400> text;  // more than the longest double has
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  out.append(text.data(), end);
}

std::string rounded_text(double value, int decimals) {
  std::array<char, 340> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                          std::chars_format::fixed, decimals);
  std::string text(digits.data(), end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

void append_integer(std::string& out, std::int64_t value) {
  std::array<char, 24> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end);
}

double decimal_of(float value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  double decimal = value;
  std::from_chars(digits.data(), end, decimal);
  return decimal;
}

tl::expected<double, NumberFault> read_number(std::string_view text) {
  const bool plus = text.starts_with('+');
  if (plus) text.remove_prefix(1);
  // What "inf" and "nan" begin with is no number either.
  const std::size_t first = plus || !text.starts_with('-') ? 0 : 1;
  if (text.find_first_of("0123456789.", first) != first) return wrong(NumberFault::no_number);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || stop != text.data() + text.size())
    return wrong(NumberFault::no_number);
  if (error == std::errc()) return value;
  if (is_below_one(text)) return 0;
  return wrong(NumberFault::too_large);
}

tl::expected<std::uint64_t, NumberFault> read_whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || stop != text.data() + text.size())
    return wrong(NumberFault::no_number);
  if (error != std::errc()) return wrong(NumberFault::too_large);
  return value;
}

}  // namespace kerf::base
