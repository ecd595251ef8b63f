#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace kerf::base {

/// What a stretch of a line is to a reader. A word that is written with blanks or comments inside
/// has a token for each of its pieces, all of one kind.
enum class TokenKind : std::uint8_t {
  blank,       ///< means nothing
  comment,     ///< with its marks
  program,     ///< number or name of a program, percent sign of a tape
  sequence,    ///< number of a block
  skip,        ///< slash of a block that a switch leaves out, with its level
  command,     ///< what the machine is told: G01, MOVE, POINT
  switching,   ///< an M code
  dimension,   ///< a word of an axis, of an arc's centre, of a cycle; the name of an axis
  technology,  ///< any other word: feed, speed, tool, offset, repetition
  keyword,     ///< of a statement
  function,    ///< of an expression
  op,          ///< operators, brackets, commas, ends of statements
  variable,
  number,
  text,    ///< what is printed, and names that a program gives
  label,   ///< where a jump may go to, a taught point's name
  target,  ///< where a jump goes to
  error    ///< no part of the language, or not here
};

/// "dimension"
[[nodiscard]] std::string_view name_of(TokenKind kind);

/// A stretch of a line. Bytes, from 0.
struct Token {
  TokenKind kind = TokenKind::blank;
  std::uint32_t begin = 0;
  std::uint32_t length = 0;
  friend bool operator==(const Token&, const Token&) = default;
};

/// The tokens of a line, made from left to right: each byte is in exactly one of them.
class TokenRow {
 public:
  /// Appends to `tokens`. Both must outlive this.
  TokenRow(std::string_view line, std::vector<Token>& tokens) : line_(line), tokens_(tokens) {}

  /// What has not been cut yet, up to `end`, is one token; nothing when there is nothing.
  /// Precondition: `end` lies in the line.
  void put(TokenKind kind, const char* end);
  /// First byte that is in no token.
  [[nodiscard]] const char* at() const { return line_.data() + done_; }
  [[nodiscard]] const char* end() const { return line_.data() + line_.size(); }
  /// The next word that stands between `blanks`, which become a token before it; empty where the
  /// line ends or its comment begins. The word itself is to be put.
  [[nodiscard]] std::string_view next_word(std::string_view blanks, char comment);

 private:
  std::string_view line_;
  std::vector<Token>& tokens_;
  std::size_t done_ = 0;
};

}  // namespace kerf::base
