#include "lang/gcode/block_cutter.hpp"

#include <algorithm>

namespace kerf::gcode {
namespace {

using base::TokenKind;

// What a word of this address is for; which axes there are is the machine's business.
TokenKind kind_of(char letter) {
  if (letter == 'G') return TokenKind::command;
  if (letter == 'M') return TokenKind::switching;
  if (letter == 'N') return TokenKind::sequence;
  if (letter == 'O') return TokenKind::program;
  constexpr std::string_view kTechnology = "DEFHLPST";
  return kTechnology.find(letter) != std::string_view::npos ? TokenKind::technology
                                                            : TokenKind::dimension;
}

bool begins_number(char c) { return is_digit(c) || c == '.'; }

bool is_one_of(char c, std::string_view characters) {
  return characters.find(c) != std::string_view::npos;
}

}  // namespace

void BlockCutter::cut() {
  while (!cursor_.done()) {
    piece();
    is_first_ = false;
  }
  fill(TokenKind::error, cursor_.end());
}

std::string_view BlockCutter::ahead() const {
  return {cursor_.at(), static_cast<std::size_t>(cursor_.end() - cursor_.at())};
}

// Blanks and comments in front of and within what the cursor took are tokens of their own.
void BlockCutter::fill(TokenKind kind, const char* to) {
  while (row_.at() < to) {
    const char* const at = row_.at();
    if (*at == '(') {
      const char* const close = std::find(at, to, ')');
      row_.put(TokenKind::comment, close == to ? to : close + 1);
    } else if (is_blank(*at)) {
      row_.put(TokenKind::blank, std::find_if_not(at, to, is_blank));
    } else {
      row_.put(kind, std::find_if(at, to, [](char c) { return c == '(' || is_blank(c); }));
    }
  }
}

void BlockCutter::piece() {
  const char next = cursor_.peek();
  if (next == '%' || (next == '&' && is_first_)) return rest(TokenKind::program);
  if (begins_program(next)) return program();
  behind_program_ = false;
  switch (mode_) {
    case Mode::head: return piece_of_head(next);
    case Mode::words: return open_ == 0 ? piece_of_words(next) : piece_of_macro(next);
    case Mode::macro: return piece_of_macro(next);
    case Mode::print:
    case Mode::names: return open_ == 1 ? piece_of_list(next) : piece_of_macro(next);
  }
}

// To the end of the block, whatever stands there: of the line of a percent sign nothing is read.
void BlockCutter::rest(TokenKind kind) {
  fill(kind, cursor_.at());
  row_.put(kind, cursor_.end());
  cursor_.move_to(cursor_.end());
}

// As program_directory finds them: an O in front of digits, outside of brackets and behind no
// letter, and at the beginning of a block ':' and a name as well.
bool BlockCutter::begins_program(char next) const {
  if (next == '<') return is_first_;
  const bool behind_letter =
      behind_program_ || (!is_first_ && is_letter(Cursor::fold(*(cursor_.behind() - 1))));
  if (next == ':' ? !is_first_ : next != 'O' || behind_letter || brackets_ > 0) return false;
  const char* const number = std::find_if_not(cursor_.at() + 1, cursor_.end(), is_blank);
  return number != cursor_.end() && (is_digit(*number) || *number == '<');
}

// Behind it another block begins. A name without an end is none.
void BlockCutter::program() {
  const char* const begin = cursor_.at();
  const char* at =
      std::find_if(begin, cursor_.end(), [](char c) { return c == '<' || is_digit(c); });
  if (*at == '<') {
    const std::string_view name = ahead().substr(static_cast<std::size_t>(at - begin));
    const std::size_t close = name.substr(0, kLongestProgramName + 2).find('>');
    at = close == std::string_view::npos ? begin + 1 : at + close + 1;
  } else {
    at = std::find_if_not(at, cursor_.end(), [](char c) { return is_blank(c) || is_digit(c); });
    while (is_blank(*(at - 1))) --at;
  }
  cursor_.move_to(at);
  fill(TokenKind::program, at);
  mode_ = Mode::head;
  is_labelled_ = false;
  behind_program_ = true;
}

void BlockCutter::piece_of_head(char next) {
  if (next == '/') return skip();
  if (next == 'N' && !is_labelled_ && !is_letter(cursor_.peek_next())) {
    is_labelled_ = true;
    return word();
  }
  mode_ = next == '#' || next == '[' ? Mode::macro : Mode::words;
  piece();
}

void BlockCutter::skip() {
  cursor_.advance();
  if (cursor_.peek() >= '1' && cursor_.peek() <= '9') cursor_.advance();
  mark(TokenKind::skip);
}

void BlockCutter::piece_of_words(char next) {
  if (is_letter(next)) {
    const KeywordMatch match =
        is_letter(cursor_.peek_next()) ? statement_at(ahead()) : KeywordMatch{};
    return match.keyword == Keyword::none ? word() : keyword(match);
  }
  if (next == '/') return skip();
  if (next == '<') return program();
  if (next == '#') return variable();
  if (next == '[' || next == ']') return bracket(next);
  if (begins_number(next)) {
    cursor_.scan_number();
    return mark(TokenKind::error);
  }
  sign();
}

// An address with its number; what else it takes its value from follows.
void BlockCutter::word() {
  const TokenKind kind = kind_of(cursor_.peek());
  cursor_.advance();
  if (is_one_of(cursor_.peek(), "+-")) cursor_.advance();
  if (begins_number(cursor_.peek())) cursor_.scan_number();
  mark(kind);
}

void BlockCutter::keyword(const KeywordMatch& match) {
  cursor_.advance(match.length);
  mark(TokenKind::keyword);
  const bool prints = match.keyword == Keyword::dprnt || match.keyword == Keyword::bprnt;
  mode_ = prints ? Mode::print : match.keyword == Keyword::setvn ? Mode::names : Mode::macro;
  behind_operand_ = false;
  behind_goto_ = match.keyword == Keyword::go_to;
}

void BlockCutter::piece_of_macro(char next) {
  if (next == '#') return variable();
  if (next == '[' || next == ']') return bracket(next);
  if (begins_number(next)) return number();
  if (is_letter(next)) return letters();
  sign();
}

// "#5", "#" in front of a bracket, "#NAME" behind one.
void BlockCutter::variable() {
  const bool may_be_named = behind_open_;
  cursor_.advance();
  const auto is_of_name = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  if (is_digit(cursor_.peek())) {
    cursor_.scan_number();
  } else if (may_be_named) {
    while (is_of_name(cursor_.peek())) cursor_.advance();
  }
  mark(TokenKind::variable);
  behind_operand_ = true;
  behind_goto_ = behind_open_ = false;
}

void BlockCutter::bracket(char bracket) {
  cursor_.advance();
  mark(TokenKind::op);
  const int step = bracket == '[' ? 1 : -1;
  brackets_ += step;
  open_ = std::max(0, open_ + step);
  behind_open_ = bracket == '[';
  behind_operand_ = bracket == ']';
  behind_goto_ = false;
}

void BlockCutter::number() {
  cursor_.scan_number();
  mark(behind_goto_ ? TokenKind::target : TokenKind::number);
  behind_operand_ = true;
  behind_goto_ = behind_open_ = false;
}

// Behind an operand an operator, otherwise a function; outside of brackets also the next word of
// the statement, or words of a block, which cannot follow there.
void BlockCutter::letters() {
  behind_goto_ = behind_open_ = false;
  KeywordMatch match = behind_operand_ ? operator_at(ahead()) : function_at(ahead());
  if (match.keyword == Keyword::none && open_ == 0) {
    match = statement_at(ahead());
    if (match.keyword != Keyword::none) return keyword(match);
    mode_ = Mode::words;
    return word();
  }
  cursor_.advance(std::max<std::size_t>(match.length, 1));
  if (match.keyword == Keyword::none) return mark(TokenKind::error);
  mark(behind_operand_ ? TokenKind::op : TokenKind::function);
  behind_operand_ = false;
}

// A foreign character of several bytes is one token.
void BlockCutter::sign() {
  const bool is_sign = is_one_of(cursor_.peek(), "+-*/=,");
  do cursor_.advance();
  while ((static_cast<unsigned char>(cursor_.peek()) & 0xC0U) == 0x80U);
  mark(is_sign ? TokenKind::op : TokenKind::error);
  behind_operand_ = behind_goto_ = behind_open_ = false;
}

// Of a list the brackets, the variables with theirs, and the text or names between.
void BlockCutter::piece_of_list(char next) {
  if (next == '#' && mode_ == Mode::print) return variable();
  if (next == '[' || next == ']') return bracket(next);
  if (next == ',' || next == '#') return sign();
  while (is_language_character(cursor_.peek()) && !cursor_.done() &&
         !is_one_of(cursor_.peek(), "#[],%"))
    cursor_.advance();
  if (row_.at() >= cursor_.behind()) return sign();
  mark(TokenKind::text);
}

}  // namespace kerf::gcode
