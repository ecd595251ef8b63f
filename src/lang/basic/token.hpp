#pragma once

#include <cstdint>
#include <string>

#include "base/diagnostic_code.hpp"
#include "lang/basic/keywords.hpp"

namespace kerf::basic {

/// Kinds of tokens (docs/laser-basic.md, Tokens). `wrong` is text that is none.
enum class TokenType : std::uint8_t {
  delimiter,
  variable,
  number,
  command,   ///< a word of the table of keywords and functions
  string,    ///< a bare word as the name of a label
  quote,     ///< text between quotation marks
  finished,  ///< end of the line
  wrong
};

enum class Delimiter : std::uint8_t {
  none,
  plus,
  minus,
  times,
  divide,
  modulo,
  power,
  assign,  ///< "=": in an expression it compares
  equal,   ///< "=="
  not_equal,
  less,
  greater,
  less_equal,
  greater_equal,
  open,
  close,
  comma,
  semicolon,
  colon
};

/// A piece of a line. `begin` to `end` is its text in the line, which must outlive it.
struct Token {
  TokenType type = TokenType::finished;
  Delimiter delimiter = Delimiter::none;
  Word word = Word::none;  ///< of a command
  base::Code mistake{};    ///< of what is wrong: LB0020, LB0021, LB0026
  double number = 0;       ///< of a number
  std::string text;        ///< words in capitals; a quote without its marks
  const char* begin = nullptr;
  const char* end = nullptr;

  [[nodiscard]] bool is(Delimiter wanted) const { return delimiter == wanted; }
  [[nodiscard]] bool is(Word wanted) const { return word == wanted; }
};

}  // namespace kerf::basic
