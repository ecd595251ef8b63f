#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::records {

/// A piece of JSON: a mark is one of `{ } [ ] , :`, a string has its quotation marks.
struct JsonPiece {
  enum class Kind : std::uint8_t { end, mark, string, number, word, wrong };
  Kind kind = Kind::end;
  std::string_view text;

  [[nodiscard]] bool is(char mark) const { return kind == Kind::mark && text[0] == mark; }
};

/// Cuts a line of JSON into its pieces. What is none is `wrong`, and the lexer goes on behind it.
class JsonLexer {
 public:
  /// It must outlive this.
  explicit JsonLexer(std::string_view line) : at_(line.data()), end_(at_ + line.size()) {}
  /// Behind the last piece an `end` of no length.
  [[nodiscard]] JsonPiece next();

 private:
  JsonPiece piece(JsonPiece::Kind kind, const char* behind);
  JsonPiece string();
  JsonPiece word();

  const char* at_;
  const char* end_;
};

/// What a string of JSON says, without its quotation marks; what \u names is UTF-8.
[[nodiscard]] std::string json_text(std::string_view string);

}  // namespace kerf::records
