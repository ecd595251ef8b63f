#include "lang/gcode/lexer.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/decimal.hpp"

namespace kerf::gcode {
namespace {

// Powers of ten that a double holds exactly: a mantissa below 2^53 divided by one of them is
// rounded once, so the quotient is the double nearest to the decimal.
constexpr std::array kPowersOfTen = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
constexpr int kExactDigits = 15;

}  // namespace

// A comment ends at the first ')' (LEX-13); one that is not closed takes the rest of the block,
// which the caller has made the rest of the line (LEX-15).
void Cursor::skip_comment() {
  const char* const close = std::find(at_, end_, ')');
  if (comment_.data() == nullptr) {
    comment_ = std::string_view(at_ + 1, static_cast<std::size_t>(close - at_ - 1));
  }
  at_ = close == end_ ? end_ : close + 1;
}

// A DEL is a character that was punched out of a tape.
void Cursor::skip_delete() {
  ++at_;
  skip();
}

char Cursor::peek_behind() const {
  Cursor copy = *this;
  copy.advance();
  return copy.peek();
}

NumberText Cursor::number() {
  const NumberText text = scan_number();
  if (!text.second_point) return text;
  throw SyntaxError{
      base::Code::illegal_decimal_point, at_, 1, "two decimal points in one number", {}};
}

// Nearly every number is a run of digits with a point somewhere and nothing between; everything
// else takes the slow way from its beginning.
NumberText Cursor::scan_number() {
  const char* const begin = at_;
  const char* at = at_;
  std::uint64_t mantissa = 0;
  for (; at != end_ && is_digit(*at); ++at)
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  std::ptrdiff_t digits = at - begin;
  std::ptrdiff_t decimals = 0;
  NumberText result;
  if (at != end_ && *at == '.') {
    result.point = true;
    const char* const fraction = ++at;
    for (; at != end_ && is_digit(*at); ++at)
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    decimals = at - fraction;
    digits += decimals;
  }
  if (digits == 0 || digits > kExactDigits) return spaced_number(begin);
  behind_ = at_ = at;
  skip();
  if (at_ != end_ && (is_digit(*at_) || *at_ == '.')) return spaced_number(begin);
  for (const char* zero = begin; digits > 0 && (*zero == '0' || *zero == '.'); ++zero)
    digits -= *zero == '0' ? 1 : 0;
  result.digits = static_cast<int>(digits);
  result.value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  return result;
}

bool Cursor::take_plain_word(PlainWord& word) {
  const char* at = at_;
  if (at == end_) return false;
  word.begin = at;
  word.letter = fold(*at++);
  if (!is_letter(word.letter)) return false;
  word.minus = at != end_ && *at == '-';
  at += word.minus ? 1 : 0;
  const char* const first = at;
  std::uint64_t mantissa = 0;
  for (; at != end_ && is_digit(*at); ++at)
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  std::ptrdiff_t digits = at - first;
  std::ptrdiff_t decimals = 0;
  word.point = at != end_ && *at == '.';
  if (word.point) {
    const char* const fraction = ++at;
    for (; at != end_ && is_digit(*at); ++at)
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    decimals = at - fraction;
    digits += decimals;
  }
  if (digits == 0 || digits > kExactDigits) return false;
  const char* next = at;
  while (next != end_ && *next == ' ') ++next;
  if (next != end_ && !is_letter(fold(*next))) return false;
  word.end = behind_ = at;
  at_ = next;
  const double value =
      static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  word.value = word.minus ? -value : value;
  return true;
}

// Blanks between digits, two points, no digits at all, or more digits than a double holds.
NumberText Cursor::spaced_number(const char* begin) {
  at_ = begin;
  NumberText result;
  std::string digits;
  for (;;) {
    const char* const run = at_;
    for (; at_ != end_ && is_digit(*at_); ++at_) {
      digits += *at_;
      result.digits += result.digits != 0 || *at_ != '0' ? 1 : 0;
    }
    const char* const run_end = at_;
    if (run_end != run) behind_ = run_end;
    skip();
    if (at_ == end_) break;
    if (*at_ == '.') {
      result.second_point = result.point;
      if (result.second_point) break;
      result.point = true;
      digits += '.';
      behind_ = ++at_;
      skip();
    } else if (!is_digit(*at_) || run_end - run > 1) {
      break;
    }
  }
  if (digits.empty() || digits == ".") {
    result.digits = -1;
    return result;
  }
  result.value = base::read_number(digits).value_or(0);  // too large has too many digits as well
  return result;
}

}  // namespace kerf::gcode
