#pragma once

#include <cstdint>
#include <string_view>

#include "base/diagnostic_code.hpp"

namespace kerf::gcode {

/// A mistake in the text of a block. Thrown inside this room only; the block parser turns it into
/// the alarm that the block raises when it is reached.
struct SyntaxError {
  base::Code code{};
  const char* at = nullptr;  ///< first byte of the offending text
  std::size_t length = 1;
  std::string_view detail = {};  ///< text with static lifetime
  std::string_view hint = {};    ///< likewise
};

/// Characters of the name of a program: O<NAME>.
inline constexpr std::size_t kLongestProgramName = 32;

/// A number as it was written.
struct NumberText {
  double value = 0;
  bool point = false;
  int digits = 0;             ///< without leading zeros
  bool second_point = false;  ///< one ended it
};

/// Walks over the text of one block. Blanks and comments mean nothing between any two characters;
/// the cursor always stands on the next character that does mean something, or at the end.
///
/// Characters come folded to upper case; the end reads as kEnd.
class Cursor {
 public:
  static constexpr char kEnd = '\0';

  explicit Cursor(std::string_view text)
      : at_(text.data()), end_(text.data() + text.size()), behind_(text.data()) {
    skip();
  }

  [[nodiscard]] const char* at() const { return at_; }
  [[nodiscard]] const char* end() const { return end_; }
  /// Behind the last character that was taken: where a token ends, before blanks and comments.
  [[nodiscard]] const char* behind() const { return behind_; }
  /// Bytes from `begin` to there; 0 when nothing has been taken since.
  [[nodiscard]] std::size_t length_since(const char* begin) const {
    return behind_ > begin ? static_cast<std::size_t>(behind_ - begin) : 0;
  }
  [[nodiscard]] bool done() const { return at_ == end_; }
  [[nodiscard]] char peek() const { return at_ == end_ ? kEnd : fold(*at_); }
  /// The character directly behind the current one, with nothing skipped between.
  [[nodiscard]] char peek_next() const { return at_ + 1 >= end_ ? kEnd : fold(at_[1]); }
  /// What follows the current character when blanks and comments are passed over.
  [[nodiscard]] char peek_behind() const;

  void advance() {
    behind_ = ++at_;
    skip();
  }
  /// Passes over `count` characters that are known to be contiguous.
  void advance(std::size_t count) {
    behind_ = at_ += count;
    skip();
  }
  /// Takes `wanted` if it is next.
  bool take(char wanted) {
    if (peek() != wanted) return false;
    advance();
    return true;
  }
  /// Digits with at most one decimal point. Blanks may stand between single digits (G 0 0 X 1 0 .);
  /// a blank behind two or more digits ends the number, so that G01 5X is the mistake that it looks
  /// like (LEX-9, LEX-12). Throws SyntaxError for a second point. Precondition: a digit or point is
  /// next; a lone point counts as no digits.
  [[nodiscard]] NumberText number();
  /// The same, but a second point ends the number, and is not taken.
  NumberText scan_number();

  /// Takes a word of the commonest form at once: a letter, perhaps a minus sign, digits with at
  /// most one point and nothing between them. False, with nothing taken, for every other form.
  struct PlainWord {
    double value = 0;
    const char* begin = nullptr;
    const char* end = nullptr;
    char letter = 0;
    bool minus = false;
    bool point = false;
  };
  [[nodiscard]] bool take_plain_word(PlainWord& word);

  void move_to(const char* at) {
    behind_ = at_ = at;
    skip();
  }

  /// The first comment that was passed over, without its parentheses.
  [[nodiscard]] std::string_view comment() const { return comment_; }
  void forget_comment() { comment_ = {}; }

  static char fold(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

 private:
  void skip() {
    while (at_ != end_ && static_cast<unsigned char>(*at_) <= '(' && is_skipped(*at_)) skip_one();
    if (at_ != end_ && *at_ == '\x7f') skip_delete();
  }
  static bool is_skipped(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '('; }
  void skip_one() {
    if (*at_ != '(') {
      ++at_;
    } else {
      skip_comment();
    }
  }
  void skip_comment();
  void skip_delete();
  NumberText spaced_number(const char* begin);

  const char* at_;
  const char* end_;
  const char* behind_;
  std::string_view comment_;
};

[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// A character that can stand in a block outside of comments; the end of the text counts as one.
[[nodiscard]] constexpr bool is_language_character(char c) {
  constexpr std::string_view kSigns = "+-*/=.,#[]<>;:%&_";
  return c == '\0' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
         kSigns.find(c) != std::string_view::npos;
}
[[nodiscard]] constexpr bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace kerf::gcode
