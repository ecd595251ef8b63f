#pragma once

#include "base/token.hpp"
#include "lang/gcode/keywords.hpp"
#include "lang/gcode/lexer.hpp"

namespace kerf::gcode {

/// Cuts the text of one block into tokens with the lexer that compiles it: Cursor says what is
/// passed over and how far a number goes, keywords.hpp which word stands where. It goes on behind
/// mistakes, where the compiler gives the block up.
class BlockCutter {
 public:
  /// `brackets` are those that the line has open before the block, for the next block likewise.
  /// Both references must outlive this.
  BlockCutter(std::string_view block, int& brackets, base::TokenRow& row)
      : cursor_(block), brackets_(brackets), row_(row) {}

  void cut();

 private:
  // What the next character is read as.
  enum class Mode : std::uint8_t {
    head,   // slashes and sequence number
    words,  // addresses and their values
    macro,  // statements and assignments
    print,  // the list of DPRNT or BPRNT
    names   // the list of SETVN
  };

  void piece();
  void piece_of_head(char next);
  void piece_of_words(char next);
  void piece_of_macro(char next);
  void piece_of_list(char next);
  [[nodiscard]] bool begins_program(char next) const;
  void program();
  void skip();
  void word();
  void keyword(const KeywordMatch& match);
  void variable();
  void bracket(char bracket);
  void number();
  void letters();
  void sign();
  void rest(base::TokenKind kind);
  void mark(base::TokenKind kind) { fill(kind, cursor_.behind()); }
  void fill(base::TokenKind kind, const char* to);
  [[nodiscard]] std::string_view ahead() const;

  Cursor cursor_;
  int& brackets_;
  base::TokenRow& row_;
  Mode mode_ = Mode::head;
  int open_ = 0;                 // brackets of this block
  bool is_first_ = true;         // nothing of the block has been taken
  bool is_labelled_ = false;     // its sequence number has
  bool behind_operand_ = false;  // an operator is next, no operand
  bool behind_goto_ = false;
  bool behind_open_ = false;     // of a bracket
  bool behind_program_ = false;  // of its number
};

/// The character means nothing between any two others.
[[nodiscard]] constexpr bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ' || c == '\x7f';
}

}  // namespace kerf::gcode
