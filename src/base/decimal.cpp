#include "base/decimal.hpp"

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

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const char* begin = text.data();
  const char* const end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace kerf::base
