#pragma once

#include <string_view>

#include "lang/basic/token.hpp"

namespace kerf::basic {

/// Cuts a line into tokens (docs/laser-basic.md, Tokens). Full-width characters outside of quotes
/// count as the ASCII ones; blanks and tabs mean nothing.
class Lexer {
 public:
  /// `line` has no end of line in it, and must outlive the tokens.
  explicit Lexer(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  /// The next token; behind the last one, and from a comment on, always `finished`.
  [[nodiscard]] Token next();

 private:
  /// A character and the bytes that it takes; 0 at the end of the line.
  struct Character {
    char value = 0;
    std::size_t length = 0;
  };

  [[nodiscard]] Character peek() const { return character_at(at_); }
  [[nodiscard]] Character character_at(const char* at) const;
  void advance() { at_ += peek().length; }
  bool take(char wanted);
  void skip_blanks();
  Token word(Token token);
  Token number(Token token);
  Token quote(Token token);
  Token sign(Token token);
  [[nodiscard]] Token done(Token token) const;
  [[nodiscard]] Token wrong(Token token, base::Code mistake) const;

  const char* at_;
  const char* end_;
};

}  // namespace kerf::basic
