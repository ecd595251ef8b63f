#include "lang/records/language.hpp"

#include <array>

#include "lang/records/json_lexer.hpp"

namespace kerf::records {
namespace {

using base::TokenKind;

constexpr std::array<std::string_view, 1> kEndings = {".jsonl"};

// No other language has a block that begins so.
bool shows(const base::FirstWord& first) { return first.word.empty() && first.next == '{'; }

TokenKind kind_of(JsonPiece::Kind piece, bool is_name) {
  switch (piece) {
    case JsonPiece::Kind::mark: return TokenKind::op;
    case JsonPiece::Kind::string: return is_name ? TokenKind::keyword : TokenKind::text;
    case JsonPiece::Kind::number: return TokenKind::number;
    case JsonPiece::Kind::word: return TokenKind::keyword;
    case JsonPiece::Kind::end:
    case JsonPiece::Kind::wrong: break;
  }
  return TokenKind::error;
}

// A string is the name of a member where a colon follows.
void cut(std::string_view line, std::vector<base::Token>& tokens) {
  base::TokenRow row(line, tokens);
  JsonLexer lexer(line);
  for (JsonPiece piece = lexer.next(); piece.kind != JsonPiece::Kind::end;) {
    const JsonPiece next = lexer.next();
    row.put(TokenKind::blank, piece.text.data());
    row.put(kind_of(piece.kind, next.is(':')), piece.text.data() + piece.text.size());
    piece = next;
  }
  row.put(TokenKind::blank, row.end());
}

}  // namespace

const base::Language& language() {
  static const base::Language language = {
      .name = "motion",
      .endings = kEndings,
      .shows_by_word = shows,
      .comment = {},
      .key_words = {},
      .example = R"({"kind":"dwell","program":"O0001","line":4,"seconds":0.5})",
      .cut = cut};
  return language;
}

}  // namespace kerf::records
