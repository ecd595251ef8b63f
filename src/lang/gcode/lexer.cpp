#include "lang/gcode/lexer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

namespace kerf::gcode {
namespace {

// Powers of ten that a double holds exactly: a mantissa below 2^53 divided by one of them is rounded
// once, so the quotient is the double nearest to the decimal.
constexpr std::array kPowersOfTen = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15};
constexpr int kExactDigits = 15;

}  // namespace

// A comment ends at the first ')' (LEX-13); one that is not closed takes the rest of the block, which
// the caller has made the rest of the line (LEX-15).
void Cursor::skip_one() {
  if (*at_ != '(') {
    ++at_;
    return;
  }
  const char* const close = std::find(at_, end_, ')');
  if (comment_.data() == nullptr) {
    comment_ = std::string_view(at_ + 1, static_cast<std::size_t>(close - at_ - 1));
  }
  at_ = close == end_ ? end_ : close + 1;
}

char Cursor::peek_behind() const {
  Cursor copy = *this;
  copy.advance();
  return copy.peek();
}

NumberText Cursor::number() {
  const char* const begin = at_;
  NumberText result;
  std::uint64_t mantissa = 0;
  int decimals = 0;
  bool any = false;
  for (;;) {
    const char* const run = at_;
    while (at_ != end_ && is_digit(*at_)) {
      any = true;
      result.digits += mantissa != 0 || *at_ != '0' ? 1 : 0;
      decimals += result.point ? 1 : 0;
      if (result.digits > kExactDigits || decimals > kExactDigits) return long_number(begin);
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at_ - '0');
      ++at_;
    }
    const char* const run_end = at_;
    if (run_end != run) behind_ = run_end;
    skip();
    if (at_ == end_) break;
    if (run_end - run > 1 && at_ != run_end && is_digit(*at_)) break;
    if (*at_ == '.') {
      if (result.point) throw SyntaxError{base::Code::illegal_decimal_point, at_, 1, "two decimal points in one number"};
      result.point = true;
      behind_ = ++at_;
      skip();
    } else if (!is_digit(*at_)) {
      break;
    }
  }
  if (!any) result.digits = -1;
  result.value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
  return result;
}

// Numbers with more digits than a double holds: the digits alone, read by the library.
NumberText Cursor::long_number(const char* begin) {
  NumberText result;
  std::string digits;
  at_ = begin;
  for (skip(); at_ != end_ && (is_digit(*at_) || *at_ == '.'); ++at_, skip()) {
    if (*at_ == '.') {
      if (result.point) throw SyntaxError{base::Code::illegal_decimal_point, at_, 1, "two decimal points in one number"};
      result.point = true;
    } else if (result.digits != 0 || *at_ != '0') {
      ++result.digits;
    }
    digits += *at_;
    behind_ = at_ + 1;
  }
  std::from_chars(digits.data(), digits.data() + digits.size(), result.value);
  return result;
}

}  // namespace kerf::gcode
