#include "lang/basic/language.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "lang/basic/lexer.hpp"

namespace kerf::basic {
namespace {

using base::TokenKind;

constexpr std::array<std::string_view, 1> kEndings = {".bas"};

// Words that begin a statement of laser BASIC and no block of G-code.
constexpr std::array kOwnWords = {Word::let,  Word::rem,  Word::print,  Word::input, Word::for_,
                                  Word::next, Word::home, Word::speed,  Word::power, Word::move,
                                  Word::line, Word::arc,  Word::circle, Word::gosub};

// "r = 2" is an assignment here and nothing in G-code.
bool shows(const base::FirstWord& first) {
  const bool is_name =
      !first.word.empty() && std::isalpha(static_cast<unsigned char>(first.word[0])) != 0;
  const bool is_own =
      std::find(kOwnWords.begin(), kOwnWords.end(), word_of(first.word)) != kOwnWords.end();
  return is_name && (first.next == '=' || is_own);
}

TokenKind kind_of(Word word) {
  if (is_function(word)) return TokenKind::function;
  return is_command(word) ? TokenKind::command : TokenKind::keyword;
}

TokenKind kind_of(const Token& token) {
  switch (token.type) {
    case TokenType::delimiter: return TokenKind::op;
    case TokenType::variable: return TokenKind::variable;
    case TokenType::number: return TokenKind::number;
    case TokenType::command: return kind_of(token.word);
    case TokenType::string: return TokenKind::label;
    case TokenType::quote: return TokenKind::text;
    case TokenType::finished: return TokenKind::comment;
    case TokenType::wrong: break;
  }
  return token.mistake == base::Code::basic_quote ? TokenKind::text : TokenKind::error;
}

// A number at the head of a line, or a name in front of a colon there.
bool is_label(const Token& first, Lexer behind) {
  return first.type == TokenType::number ||
         (first.type == TokenType::variable && behind.next().is(Delimiter::colon));
}

// Behind THEN and ELSE a number is a jump.
bool is_target(const Token& token, Word before) {
  const bool is_number = token.type == TokenType::number;
  if (before == Word::go_to || before == Word::gosub)
    return is_number || token.type == TokenType::variable;
  return is_number && (before == Word::then || before == Word::else_);
}

void cut(std::string_view line, std::vector<base::Token>& tokens) {
  base::TokenRow row(line, tokens);
  Lexer lexer(line);
  Token token = lexer.next();
  bool labels = is_label(token, lexer);
  for (Word before = Word::none; token.type != TokenType::finished; token = lexer.next()) {
    row.put(TokenKind::blank, token.begin);
    const TokenKind kind = is_target(token, before) ? TokenKind::target : kind_of(token);
    row.put(labels ? TokenKind::label : kind, token.end);
    before = token.word;
    labels = false;
  }
  row.put(TokenKind::blank, token.begin);
  row.put(TokenKind::comment, row.end());
}

}  // namespace

const base::Language& language() {
  static const base::Language language = {.name = "laser-basic",
                                          .endings = kEndings,
                                          .shows_by_word = shows,
                                          .comment = {"'"},
                                          .key_words = key_words(),
                                          .example = "speed(20); move(10, 10)",
                                          .cut = cut};
  return language;
}

}  // namespace kerf::basic
