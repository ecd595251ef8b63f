#include "lang/basic/lexer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"

namespace kerf::basic {
namespace {

// What stands for a character that is none of the language.
constexpr char kForeign = '\x01';

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
// Bytes of the UTF-8 character that begins with this byte.
constexpr std::ptrdiff_t length_of(unsigned char first) {
  return first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
}
constexpr char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

struct Sign {
  char character;
  Delimiter delimiter;
};
constexpr std::array kSigns = {
    Sign{'+', Delimiter::plus},      Sign{'-', Delimiter::minus},  Sign{'*', Delimiter::times},
    Sign{'/', Delimiter::divide},    Sign{'%', Delimiter::modulo}, Sign{'^', Delimiter::power},
    Sign{'(', Delimiter::open},      Sign{')', Delimiter::close},  Sign{',', Delimiter::comma},
    Sign{';', Delimiter::semicolon}, Sign{':', Delimiter::colon}};

}  // namespace

// U+FF01 to U+FF5E are the ASCII characters 0x21 to 0x7E in full width, U+3000 is the blank. The
// mark that some editors put in front of a file, U+FEFF, is none.
Lexer::Character Lexer::character_at(const char* at) const {
  if (at == end_) return {};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(at[i]); };
  if (byte(0) < 0x80) return {*at == '\0' ? kForeign : *at, 1};
  const std::ptrdiff_t length = length_of(byte(0));
  const bool whole = end_ - at >= length && std::all_of(at + 1, at + length, [](char c) {
                       return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
                     });
  if (!whole) return {kForeign, 1};
  if (length != 3) return {kForeign, static_cast<std::size_t>(length)};
  const unsigned code = (byte(0) & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU);
  if (code == 0x3000 || code == 0xFEFF) return {' ', 3};
  if (code >= 0xFF01 && code <= 0xFF5E) return {static_cast<char>(code - 0xFEE0), 3};
  return {kForeign, 3};
}

bool Lexer::take(char wanted) {
  const Character next = peek();
  if (next.value != wanted) return false;
  at_ += next.length;
  return true;
}

// A CR that ends no line is a blank.
void Lexer::skip_blanks() {
  while (peek().value == ' ' || peek().value == '\t' || peek().value == '\r') advance();
}

Token Lexer::done(Token token) const {
  token.end = at_;
  return token;
}

Token Lexer::wrong(Token token, base::Code mistake) const {
  token.type = TokenType::wrong;
  token.mistake = mistake;
  return done(std::move(token));
}

Token Lexer::next() {
  skip_blanks();
  Token token;
  token.begin = at_;
  const char first = peek().value;
  if (first == 0 || first == '\'') {
    at_ = end_;
    token.end = token.begin;
    return token;
  }
  if (is_letter(first)) return word(std::move(token));
  if (is_digit(first)) return number(std::move(token));
  if (first == '.' && is_digit(character_at(at_ + peek().length).value))
    return number(std::move(token));
  if (first == '"') return quote(std::move(token));
  return sign(std::move(token));
}

Token Lexer::word(Token token) {
  for (; is_letter(peek().value) || is_digit(peek().value); advance())
    token.text += capital(peek().value);
  token.word = word_of(token.text);
  token.type = token.word == Word::none ? TokenType::variable : TokenType::command;
  if (token.word != Word::rem) return done(std::move(token));
  at_ = end_;
  Token end;
  end.begin = end.end = token.begin;
  return end;
}

// digits [ "." digits ] | "." digits, then perhaps "e" [ sign ] digits. What is glued behind it is
// part of the mistake.
Token Lexer::number(Token token) {
  token.type = TokenType::number;
  const auto digits = [&] {
    for (; is_digit(peek().value); advance()) token.text += peek().value;
  };
  digits();
  bool bare_point = false;
  if (peek().value == '.') {
    token.text += '.';
    advance();
    bare_point = !is_digit(peek().value);
    digits();
  }
  if (capital(peek().value) == 'E') {
    const char* const before = at_;
    advance();
    std::string exponent = "e";
    if (peek().value == '+' || peek().value == '-') {
      if (peek().value == '-') exponent += '-';
      advance();
    }
    if (is_digit(peek().value)) {
      token.text += exponent;
      digits();
    } else {
      at_ = before;
    }
  }
  bool glued = false;
  for (; is_letter(peek().value) || is_digit(peek().value) || peek().value == '.'; advance())
    glued = true;
  const auto value = base::read_number(token.text);
  if (bare_point || glued || !value) return wrong(std::move(token), base::Code::basic_number);
  token.number = *value;
  return done(std::move(token));
}

// A quotation mark of full width may close with one of either kind.
Token Lexer::quote(Token token) {
  token.type = TokenType::quote;
  const bool wide = peek().length > 1;
  advance();
  for (; at_ != end_; at_ += std::max<std::size_t>(1, peek().length)) {
    const Character next = peek();
    if (next.value == '"' && (wide || next.length == 1)) {
      advance();
      return done(std::move(token));
    }
    token.text.append(at_, std::max<std::size_t>(1, next.length));
  }
  return wrong(std::move(token), base::Code::basic_quote);
}

Token Lexer::sign(Token token) {
  token.type = TokenType::delimiter;
  const char first = peek().value;
  advance();
  switch (first) {
    case '=': token.delimiter = take('=') ? Delimiter::equal : Delimiter::assign; break;
    case '<':
      token.delimiter = take('=')   ? Delimiter::less_equal
                        : take('>') ? Delimiter::not_equal
                                    : Delimiter::less;
      break;
    case '>': token.delimiter = take('=') ? Delimiter::greater_equal : Delimiter::greater; break;
    case '!':
      if (take('=')) token.delimiter = Delimiter::not_equal;
      break;
    default:
      for (const Sign& sign : kSigns) {
        if (sign.character == first) token.delimiter = sign.delimiter;
      }
  }
  if (token.delimiter == Delimiter::none)
    return wrong(std::move(token), base::Code::basic_character);
  return done(std::move(token));
}

}  // namespace kerf::basic
