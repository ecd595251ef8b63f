#include "drawing/svg/internal/scanner.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "base/decimal.hpp"
#include "drawing/small_letters.hpp"

namespace kerf::drawing::svg {
namespace {

/// Both whole and power are exact in doubles, so their product or quotient is the nearest double.
constexpr std::uint64_t kExactWhole = std::uint64_t{1} << 53U;
constexpr int kExactPower = 22;
constexpr std::array<double, kExactPower + 1> kPowers{
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// How a number is written.
struct Written {
  std::size_t length = 0;  ///< 0: it is none
  std::uint64_t whole = 0;
  int digits = 0;
  int power = 0;  ///< of ten
};

/// Digits from `at` on.
std::size_t take_digits(std::string_view text, std::size_t at, Written& number) {
  for (; at < text.size() && is_digit(text[at]); ++at) {
    if (number.digits < 18)
      number.whole = 10 * number.whole + static_cast<unsigned>(text[at] - '0');
    if (number.whole != 0) ++number.digits;
  }
  return at;
}

/// "e5" behind a number, but not the e of "em".
std::size_t take_power(std::string_view text, std::size_t at, Written& number) {
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t digit = at + 1;
  const bool has_sign = digit < text.size() && (text[digit] == '-' || text[digit] == '+');
  if (has_sign) ++digit;
  if (digit >= text.size() || !is_digit(text[digit])) return at;
  int power = 0;
  std::size_t end = digit;
  for (; end < text.size() && is_digit(text[end]); ++end)
    power = std::min(10 * power + (text[end] - '0'), 9999);
  number.power += has_sign && text[digit - 1] == '-' ? -power : power;
  return end;
}

Written written(std::string_view text) {
  Written number;
  std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t whole_at = at;
  at = take_digits(text, at, number);
  std::size_t count = at - whole_at;
  if (at < text.size() && text[at] == '.') {
    const std::size_t point = at + 1;
    at = take_digits(text, point, number);
    count += at - point;
    number.power -= static_cast<int>(std::min<std::size_t>(at - point, 9999));
  }
  if (count == 0) return {};
  number.length = take_power(text, at, number);
  return number;
}

double slowly(std::string_view text) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  if (const auto value = base::read_number(text)) return *value;
  return text[0] == '-' ? -kEndless : kEndless;
}

}  // namespace

void Scanner::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

void Scanner::skip_comma() {
  skip_blanks();
  if (peek() != ',') return;
  ++at_;
  skip_blanks();
}

bool Scanner::take(char mark) {
  if (peek() != mark || is_done()) return false;
  ++at_;
  return true;
}

bool Scanner::is_at_number() const {
  const std::size_t sign = peek() == '-' || peek() == '+' ? 1 : 0;
  if (is_digit(look(sign))) return true;
  return look(sign) == '.' && is_digit(look(sign + 1));
}

std::optional<double> Scanner::number() {
  const std::string_view text = rest();
  const Written number = written(text);
  if (number.length == 0) return std::nullopt;
  at_ += number.length;
  const bool is_exact = number.digits <= 18 && number.whole <= kExactWhole &&
                        number.power >= -kExactPower && number.power <= kExactPower;
  if (!is_exact) return slowly(text.substr(0, number.length));
  const auto whole = static_cast<double>(number.whole);
  const double value = number.power < 0 ? whole / kPowers[static_cast<std::size_t>(-number.power)]
                                        : whole * kPowers[static_cast<std::size_t>(number.power)];
  return text[0] == '-' ? -value : value;
}

std::optional<bool> Scanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  return text_[at_++] == '1';
}

std::string_view Scanner::word() {
  const auto is_part = [](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
  };
  const std::size_t from = at_;
  while (at_ < text_.size() && is_part(text_[at_])) ++at_;
  return text_.substr(from, at_ - from);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool same_letters(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return small_letter(x) == small_letter(y);
         });
}

std::optional<std::string_view> local_reference(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with("url(")) {
    text = trimmed(text.substr(4, text.find(')') - 4));
    const bool is_quoted = text.size() > 1 && (text[0] == '"' || text[0] == '\'');
    if (is_quoted) text = text.substr(1, text.find(text[0], 1) - 1);
  }
  if (!text.starts_with('#')) return std::nullopt;
  return text.substr(1);
}

std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  Scanner in(text);
  in.skip_blanks();
  while (!in.is_done()) {
    const auto number = in.number();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    in.skip_comma();
  }
  return numbers;
}

}  // namespace kerf::drawing::svg
