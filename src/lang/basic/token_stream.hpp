#pragma once

#include <string>

#include "lang/basic/lexer.hpp"

namespace kerf::basic {

/// Why a statement does not compile. Thrown and caught within this room.
struct SyntaxError {
  base::Code code{};
  const char* begin = nullptr;
  const char* end = nullptr;
  std::string detail{};
};

/// Why a statement is wrong that needs more registers, or a deeper stack, than there are.
inline constexpr const char* kTooDeep = "the expression is nested too deeply";

/// The tokens of a line, one ahead.
class TokenStream {
 public:
  explicit TokenStream(std::string_view line) : lexer_(line), next_(lexer_.next()) {}

  [[nodiscard]] const Token& peek() const { return next_; }
  [[nodiscard]] bool at_end() const { return next_.type == TokenType::finished; }
  [[nodiscard]] bool at_end_of_statement() const {
    return at_end() || next_.is(Delimiter::semicolon) || next_.is(Word::else_);
  }
  Token take() {
    Token taken = std::move(next_);
    next_ = lexer_.next();
    behind_ = taken.end;
    return taken;
  }
  bool take(Delimiter wanted) { return next_.is(wanted) && (take(), true); }
  bool take(Word wanted) { return next_.is(wanted) && (take(), true); }

  /// The end of the last token that was taken.
  [[nodiscard]] const char* behind() const { return behind_; }

  [[noreturn]] void fail(base::Code code, std::string detail = {}) const {
    throw SyntaxError{code, next_.begin, next_.end, std::move(detail)};
  }
  /// Something stands here that cannot: `code` says so, unless it is a mistake of its own.
  [[noreturn]] void unexpected(base::Code code, std::string detail = {}) const {
    if (next_.is(Delimiter::close))
      fail(base::Code::basic_brackets, "nothing is open that this one closes");
    fail(next_.type == TokenType::wrong ? next_.mistake : code, std::move(detail));
  }

 private:
  Lexer lexer_;
  Token next_;
  const char* behind_ = nullptr;
};

}  // namespace kerf::basic
