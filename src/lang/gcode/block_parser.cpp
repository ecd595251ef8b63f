#include "lang/gcode/block_parser.hpp"

#include <algorithm>

#include "lang/gcode/call_codes.hpp"

namespace kerf::gcode {
namespace {

using base::Code;
using vm::Op;

constexpr int kLabelDigits = 8;

std::string_view rest(const Cursor& cursor) {
  return {cursor.at(), static_cast<std::size_t>(cursor.end() - cursor.at())};
}

// The statement word at the cursor. An address is one letter, so two letters side by side begin a
// word of the macro language or a mistake.
KeywordMatch statement_word(const Cursor& cursor) {
  if (!is_letter(cursor.peek()) || !is_letter(cursor.peek_next())) return {};
  return statement_at(rest(cursor));
}

[[noreturn]] void fail_at(const Cursor& cursor, Code code, std::string_view detail = {},
                          std::string_view hint = {}) {
  throw SyntaxError{code, cursor.at(), cursor.done() ? 0U : 1U, detail, hint};
}

[[noreturn]] void fail_since(const char* begin, const Cursor& cursor, Code code,
                             std::string_view detail = {}, std::string_view hint = {}) {
  throw SyntaxError{code, begin, cursor.length_since(begin), detail, hint};
}

}  // namespace

void BlockParser::compile(const BlockText& text) {
  Cursor cursor(text.text);
  if (cursor.done()) return;
  line_begin_ = text.line_begin;
  arguments_ = false;
  from_registers_ = false;
  may_call_ = false;
  emitter_.begin_block(text.line_begin);
  page_.marks.push_back({emitter_.here(), text.line, text.offset, text.line_offset,
                         static_cast<std::uint32_t>(text.text.size()), 0});
  const std::uint32_t begin = emitter_.here();
  const std::size_t first_loop = page_.loop_marks.size();
  try {
    block(cursor, text);
  } catch (const SyntaxError& error) {
    page_.instructions.resize(begin);
    page_.spans.resize(begin);
    page_.loop_marks.resize(first_loop);
    if (error.code == Code::nc_and_macro) keep_loop_end(error, text);
    report(error, text);
  }
}

void BlockParser::report(const SyntaxError& error, const BlockText& text) {
  const auto column = static_cast<std::uint32_t>(error.at - text.line_begin + 1);
  base::Place place{.file = page_.file,
                    .line = text.line,
                    .column = column,
                    .length = static_cast<std::uint32_t>(error.length),
                    .line_start = page_.text_begin + text.line_offset};
  page_.failures.push_back(
      base::make_error(error.code, place, std::string(error.detail), std::string(error.hint)));
  emitter_.stand_at(error.at, error.at + error.length);
  emitter_.emit({Op::fail, 0, 0, 0, static_cast<std::uint32_t>(page_.failures.size() - 1)});
}

// An END that shares its block with words is still the END of its loop: the alarm comes when the
// loop gets there, not at its DO.
void BlockParser::keep_loop_end(const SyntaxError& error, const BlockText& text) {
  const char* const end = text.text.data() + text.text.size();
  const KeywordMatch match = statement_at({error.at, static_cast<std::size_t>(end - error.at)});
  if (match.keyword != Keyword::end) return;
  const char* const digit = error.at + match.length;
  if (digit == end || *digit < '1' || *digit > '3') return;
  page_.loop_marks.push_back({static_cast<std::uint8_t>(*digit - '0'), true, emitter_.here()});
}

void BlockParser::fail_long_line(std::uint32_t line, std::uint32_t line_offset) {
  page_.marks.push_back({emitter_.here(), line, line_offset, line_offset, 0, 0});
  const char* const begin = "";
  emitter_.begin_block(begin);
  report({Code::block_too_long, begin, 1, "more than 1,048,576 characters on one line", {}},
         {{}, begin, line, line_offset, line_offset});
}

// block = { "/" [level] | N label } ( words | statement | nothing )
void BlockParser::block(Cursor& cursor, const BlockText&) {
  const std::vector<std::uint32_t> skips = head(cursor);
  cursor.forget_comment();
  if (!cursor.done()) {
    const KeywordMatch match = statement_word(cursor);
    const char next = cursor.peek();
    if (match.keyword != Keyword::none) {
      cursor.advance(match.length);
      statements_.statement(cursor, match);
    } else if (next == '#' || next == '[') {
      statements_.assignment(cursor);
    } else {
      words(cursor);
    }
  }
  for (const std::uint32_t skip : skips) emitter_.land(skip);
}

// Slashes and the sequence number, in either order (LEX-6, LEX-20).
std::vector<std::uint32_t> BlockParser::head(Cursor& cursor) {
  std::vector<std::uint32_t> skips;
  bool labelled = false;
  for (;;) {
    const char next = cursor.peek();
    if (next == '/') {
      emitter_.stand_at(cursor.at(), cursor.at() + 1);
      skips.push_back(emitter_.emit({Op::skip_when_on, skip_level(cursor), 0, 0, 0}));
    } else if (next == 'N' && !labelled && !is_letter(cursor.peek_next())) {
      label(cursor);
      labelled = true;
    } else {
      return skips;
    }
  }
}

std::uint8_t BlockParser::skip_level(Cursor& cursor) {
  cursor.advance();
  const char digit = cursor.peek();
  if (digit < '1' || digit > '9') return 1;
  cursor.advance();
  return static_cast<std::uint8_t>(digit - '0');
}

void BlockParser::label(Cursor& cursor) {
  const char* const begin = cursor.at();
  cursor.advance();
  const char next = cursor.peek();
  if (next == '#' || next == '[') {
    fail_since(begin, cursor, Code::expression_format, "a sequence number is written in digits");
  }
  if (next == '-') fail_since(begin, cursor, Code::illegal_minus);
  if (!is_digit(next)) fail_since(begin, cursor, Code::no_data_after_address);
  const NumberText text = cursor.number();
  if (text.point) fail_since(begin, cursor, Code::illegal_decimal_point);
  if (text.digits > kLabelDigits) {
    fail_since(begin, cursor, Code::too_many_digits, "a sequence number has at most 8 digits");
  }
  const auto number = static_cast<std::uint32_t>(text.value);
  if (number == 0) return;  // LEX-7: no label
  page_.marks.back().sequence = number;
  page_.labels.push_back({number, page_.marks.back().instruction});
  emitter_.emit({Op::note, 0, 0, 0, number});
}

// words = { address value | "," address value | "/" [level] | "<" name ">" }
void BlockParser::words(Cursor& cursor) {
  const char* const begin = cursor.at();
  const auto first = static_cast<std::uint32_t>(page_.words.size());
  first_word_ = first;
  Statement statement{.first = first, .mark = static_cast<std::uint32_t>(page_.marks.size() - 1)};
  std::vector<MidSkip> skips;
  while (!cursor.done()) {
    const char next = cursor.peek();
    if (plain_word(cursor)) continue;
    if (is_letter(next) || next == ',') {
      word(cursor);
    } else if (next == '/') {
      emitter_.stand_at(cursor.at(), cursor.at() + 1);
      const std::uint32_t skip = emitter_.emit({Op::skip_when_on, skip_level(cursor), 0, 0, 0});
      skips.push_back({skip, static_cast<std::uint32_t>(page_.words.size()) - first});
    } else if (next == '<') {
      program_name(cursor, statement);
    } else {
      stray(cursor);
    }
  }
  statement.from_registers = from_registers_;
  statement.may_call = may_call_;
  emitter_.stand_at(begin, cursor.behind());
  do_words(statement, static_cast<std::uint32_t>(page_.words.size()) - first);
  finish_mid_skips(statement, skips);
}

void BlockParser::do_words(Statement statement, std::uint32_t count) {
  statement.count = count;
  page_.statements.push_back(statement);
  emitter_.emit({Op::do_block, 0, 0, 0, static_cast<std::uint32_t>(page_.statements.size() - 1)});
}

// With the switch of a slash in mid-block on, the words before it are the whole block (LEX-19).
void BlockParser::finish_mid_skips(const Statement& statement, const std::vector<MidSkip>& skips) {
  std::vector<std::uint32_t> jumps;
  for (const MidSkip& skip : skips) {
    jumps.push_back(emitter_.emit({Op::jump, 0, 0, 0, 0}));
    emitter_.land(skip.instruction);
    do_words(statement, skip.words);
  }
  for (const std::uint32_t jump : jumps) emitter_.land(jump);
}

// What stands where a word should begin (LEX-12, LEX-33).
void BlockParser::stray(Cursor& cursor) {
  const char next = cursor.peek();
  Expression expression(cursor, emitter_, names_);
  if (next == '#' || (next == '[' && expression.at_named_variable())) {
    check_words_first(cursor);
    fail_at(cursor, Code::nc_and_macro, "an assignment stands behind NC words");
  }
  if (next == ']') fail_at(cursor, Code::missing_open_bracket);
  if (is_digit(next) || std::string_view("+-.*=[").find(next) != std::string_view::npos) {
    fail_at(cursor, Code::invalid_break_point, "an address letter is expected here",
            next == '+' || next == '-' || next == '*'
                ? "an expression in a word needs brackets: X[#1+2.]"
                : "");
  }
  fail_at(cursor, Code::improper_address, "this character is not part of the language");
}

// Lexical mistakes of the whole block come before structural ones (docs/dialect.md §13).
void BlockParser::check_words_first(const Cursor& cursor) {
  constexpr std::string_view kIntegers = "MSTDHLN";
  for (std::size_t i = first_word_; i < page_.words.size(); ++i) {
    const Word& word = page_.words[i];
    if (word.has(WordFlag::point) && kIntegers.find(word.letter) != std::string_view::npos) {
      throw SyntaxError{Code::illegal_decimal_point,
                        line_begin_ + word.text.column - 1,
                        word.text.length,
                        {},
                        {}};
    }
  }
  for (Cursor ahead = cursor; !ahead.done(); ahead.advance()) {
    if (!is_language_character(ahead.peek())) {
      fail_at(ahead, Code::improper_address, "this character is not part of the language");
    }
  }
}

bool BlockParser::plain_word(Cursor& cursor) {
  Cursor::PlainWord plain;
  if (!cursor.take_plain_word(plain)) return false;
  Word word;
  word.value = plain.value;
  word.letter = plain.letter;
  word.flags = static_cast<std::uint8_t>(WordFlag::literal | (plain.point ? WordFlag::point : 0) |
                                         (plain.minus ? WordFlag::minus : 0));
  if (plain.letter == 'G') note_g(plain.value);
  finish_word(plain.begin, plain.end, word);
  return true;
}

// Codes of program calls: what follows them are arguments.
void BlockParser::note_g(double code) {
  const bool ends = code == kModalCallOff;
  if (code != kMacroCall && code != kModalCall && code != kModalCallEveryBlock && !ends) return;
  may_call_ = true;
  arguments_ |= !ends;
}

// value = [+|-] ( number | "#…" | "[" expression "]" )
void BlockParser::word(Cursor& cursor) {
  const char* const begin = cursor.at();
  Word word;
  if (cursor.peek() == ',') {
    word.flags |= WordFlag::comma;
    cursor.advance();
    if (!is_letter(cursor.peek())) {
      fail_since(begin, cursor, Code::improper_address, "a comma stands only before C and R",
                 "a decimal point was probably meant");
    }
  }
  if (is_letter(cursor.peek_next())) {
    if (statement_word(cursor).keyword != Keyword::none) {
      check_words_first(cursor);
      fail_at(cursor, Code::nc_and_macro, "a macro statement stands behind NC words");
    }
    fail_at(cursor, Code::no_data_after_address, {},
            cursor.peek_next() == 'O' ? "is the letter O a digit 0?" : "");
  }
  word.letter = cursor.peek();
  cursor.advance();
  bool minus = false;
  if (cursor.peek() == '-' || cursor.peek() == '+') {
    minus = cursor.peek() == '-';
    cursor.advance();
  }
  const char next = cursor.peek();
  if (is_digit(next) || next == '.') {
    literal(cursor, word, minus);
    if (word.letter == 'G') note_g(word.value);
  } else if (next == '#' || next == '[') {
    if (word.letter == 'O' && !arguments_) {
      fail_since(begin, cursor, Code::expression_format, "a program number is written in digits");
    }
    Expression expression(cursor, emitter_, names_);
    expression.set_address(arguments_ ? '\0' : word.letter);
    const Operand operand =
        next == '[' && !expression.at_named_variable()
            ? expression.bracketed_number()
            : expression.load(next == '#' ? expression.variable() : expression.named_variable());
    if (minus) word.flags |= WordFlag::minus;
    if (operand.is_constant) {
      word.value = minus ? -operand.value : operand.value;
      if (word.letter == 'G') note_g(word.value);
    } else {
      word.value = operand.reg;
      word.flags |= WordFlag::from_register;
      from_registers_ = true;
      may_call_ |= word.letter == 'G';
    }
  } else {
    fail_since(begin, cursor, Code::no_data_after_address, {},
               next == 'O' ? "is the letter O a digit 0?" : "");
  }
  finish_word(begin, cursor.behind(), word);
}

void BlockParser::literal(Cursor& cursor, Word& word, bool minus) {
  const char* const begin = cursor.at();
  const NumberText text = cursor.number();
  if (text.digits < 0)
    fail_since(begin, cursor, Code::no_data_after_address, "a point without digits is no number");
  word.value = minus ? -text.value : text.value;
  word.flags |= static_cast<std::uint8_t>(WordFlag::literal | (text.point ? WordFlag::point : 0) |
                                          (minus ? WordFlag::minus : 0));
}

// By value: a word is two registers. Built in memory piece by piece and copied as a whole it costs
// the processor more than all the rest of a plain word.
void BlockParser::finish_word(const char* begin, const char* end, Word word) {
  page_.words.push_back(
      {word.value, word.letter, word.flags, vm::Span::between(begin, end, line_begin_)});
}

void BlockParser::program_name(Cursor& cursor, Statement& statement) {
  const char* const begin = cursor.at();
  const char* const close = std::find(begin, cursor.end(), '>');
  const auto length = static_cast<std::size_t>(close - begin);
  if (close == cursor.end() || length < 2 || length > kLongestProgramName + 1) {
    throw SyntaxError{
        Code::file_call_format, begin, length, "a program name stands between < and >", {}};
  }
  statement.name = static_cast<std::int32_t>(page_.names.size());
  page_.names.emplace_back(begin + 1, close);
  cursor.move_to(close + 1);
}

}  // namespace kerf::gcode
