#include "lang/gcode/statement_parser.hpp"

#include <cmath>

namespace kerf::gcode {
namespace {

using base::Code;
using vm::Op;

constexpr double kLargestLabel = 99999999;
constexpr std::size_t kLongestVariableName = 8;
constexpr int kMostPrintDigits = 8;

[[noreturn]] void fail(const Cursor& cursor, Code code, std::string_view detail = {},
                       std::string_view hint = {}) {
  throw SyntaxError{code, cursor.at(), cursor.done() ? 0U : 1U, detail, hint};
}

KeywordMatch keyword_at(const Cursor& cursor) {
  return statement_at({cursor.at(), static_cast<std::size_t>(cursor.end() - cursor.at())});
}

bool take_keyword(Cursor& cursor, Keyword wanted) {
  const KeywordMatch match = keyword_at(cursor);
  if (match.keyword != wanted) return false;
  cursor.advance(match.length);
  return true;
}

bool is_print_character(char c) {
  return is_letter(c) || is_digit(c) || std::string_view("+-*/.").find(c) != std::string_view::npos;
}

bool nameable(double number) {
  return (number >= 100 && number <= 199) || (number >= 500 && number <= 999);
}

}  // namespace

void StatementParser::statement(Cursor& cursor, const KeywordMatch& match) {
  switch (match.keyword) {
    case Keyword::if_: return if_statement(cursor);
    case Keyword::go_to:
      go_to(cursor);
      // "GO1X1." with the letter O: GOTO1 and something behind it.
      if (match.length == 2) return expect_end(cursor, "GO is GOTO; G0 is written with a zero");
      break;
    case Keyword::while_: return while_statement(cursor);
    case Keyword::do_: do_statement(cursor, emitter_.here(), false, {}); break;
    case Keyword::end: end_statement(cursor); break;
    case Keyword::popen: host_statement(StatementKind::popen, 0, 0); break;
    case Keyword::pclos: host_statement(StatementKind::pclos, 0, 0); break;
    case Keyword::dprnt: print(cursor, StatementKind::dprnt); break;
    case Keyword::bprnt: print(cursor, StatementKind::bprnt); break;
    case Keyword::setvn: name_variables(cursor); break;
    default: fail(cursor, Code::if_format, "THEN stands without IF");
  }
  expect_end(cursor);
}

// What may not follow a macro statement in its block.
void StatementParser::expect_end(Cursor& cursor, std::string_view hint) {
  if (cursor.done()) return;
  const char next = cursor.peek();
  if (next == ']') fail(cursor, Code::missing_open_bracket);
  if (is_letter(next) || next == '#') {
    fail(cursor, Code::nc_and_macro, "something else stands behind the macro statement", hint);
  }
  if (!is_language_character(next)) {
    fail(cursor, Code::improper_address, "this character is not part of the language");
  }
  fail(cursor, Code::expression_format, "the statement should end here");
}

// assignment = variable "=" expression
void StatementParser::assignment(Cursor& cursor) {
  Expression expression(cursor, emitter_, names_);
  if (cursor.peek() == '[' && !expression.at_named_variable()) {
    const std::string_view rest(cursor.at(), static_cast<std::size_t>(cursor.end() - cursor.at()));
    if (is_letter(cursor.peek_next()) && rest.find(']') == std::string_view::npos)
      fail(cursor, Code::improper_address, "no bracket begins a block",
           "[BILLET, [TOOLDEF and the like are for the simulators of Denford");
    fail(cursor, Code::expression_format, "a bracket cannot begin a block");
  }
  const Variable target =
      cursor.peek() == '[' ? expression.named_variable() : expression.variable();
  if (!cursor.take('=')) {
    fail(cursor, Code::missing_equals, {}, cursor.peek() == ':' ? "':=' is another control's" : "");
  }
  const Operand value = expression.number();
  expression.store(target, value);
  expect_end(cursor);
  const std::string_view comment = cursor.comment();
  const Op last = page_.instructions.back().op;
  if (!comment.empty() && (last == Op::write || last == Op::write_fixed)) {
    page_.comments.push_back(
        {static_cast<std::uint32_t>(page_.marks.size() - 1), std::string(comment)});
  }
}

// if = "IF" "[" condition "]" ( "GOTO" n | "THEN" ( assignment | "GOTO" n ) )
void StatementParser::if_statement(Cursor& cursor) {
  Expression expression(cursor, emitter_, names_);
  const Operand condition = expression.bracketed_condition(Code::if_format);
  const std::uint32_t skip = expression.branch(condition, false);
  if (take_keyword(cursor, Keyword::go_to)) {
    go_to(cursor);
    expect_end(cursor);
  } else if (take_keyword(cursor, Keyword::then)) {
    if (take_keyword(cursor, Keyword::go_to)) {
      go_to(cursor);
      expect_end(cursor);
    } else if (cursor.peek() == '#' || (cursor.peek() == '[' && expression.at_named_variable())) {
      assignment(cursor);
    } else {
      fail(cursor, Code::if_format, "behind THEN stands one assignment or GOTO",
           cursor.done() ? "IF blocks with ELSE and ENDIF are another control's" : "");
    }
  } else {
    fail(cursor, Code::if_format, "GOTO or THEN is expected here");
  }
  emitter_.land(skip);
}

// goto = "GOTO" ( n | variable | "[" expression "]" )
void StatementParser::go_to(Cursor& cursor) {
  const char* const begin = cursor.at();
  const char next = cursor.peek();
  Expression expression(cursor, emitter_, names_);
  if (is_digit(next)) {
    const double label = std::round(cursor.number().value);
    if (label < 1 || label > kLargestLabel) {
      throw SyntaxError{Code::label_range, begin, cursor.length_since(begin), {}, {}};
    }
    emitter_.stand_at(begin, cursor.behind());
    emitter_.emit({Op::jump_to_label, 0, 0, 1, static_cast<std::uint32_t>(label)});
    return;
  }
  if (next == '-') fail(cursor, Code::label_range, "a sequence number is positive");
  if (next != '#' && next != '[') fail(cursor, Code::macro_format, "GOTO needs a sequence number");
  const Operand operand =
      next == '#' ? expression.load(expression.variable()) : expression.bracketed_number();
  const Operand label = expression.call(Function::label, operand, begin);
  emitter_.stand_at(begin, cursor.behind());
  emitter_.emit({Op::jump_to_label, 0, label.reg, 0, 0});
}

// while = "WHILE" "[" condition "]" "DO" m
void StatementParser::while_statement(Cursor& cursor) {
  const std::uint32_t head = emitter_.here();
  Expression expression(cursor, emitter_, names_);
  const Operand condition = expression.bracketed_condition(Code::while_format);
  if (!take_keyword(cursor, Keyword::do_)) {
    fail(cursor, Code::while_format, "DO is expected here",
         cursor.peek() == 'D' ? "is the digit 0 a letter O?" : "");
  }
  do_statement(cursor, head, true, condition);
  expect_end(cursor);
}

void StatementParser::do_statement(Cursor& cursor, std::uint32_t head, bool conditional,
                                   const Operand& condition) {
  Expression expression(cursor, emitter_, names_);
  const std::uint32_t enter = conditional ? expression.branch(condition, true) : 0;
  const std::uint8_t slot = loop_number(cursor);
  const auto region = static_cast<std::uint32_t>(page_.regions.size());
  page_.regions.push_back({.slot = slot, .head = head});
  page_.loop_marks.push_back({slot, false, region});
  if (conditional) {
    emitter_.emit({Op::leave_region, slot, 0, 0, region});
    emitter_.land(enter);
  }
  emitter_.emit({Op::enter_region, slot, 0, 0, region});
}

void StatementParser::end_statement(Cursor& cursor) {
  const std::uint8_t slot = loop_number(cursor);
  page_.loop_marks.push_back({slot, true, emitter_.here()});
  emitter_.emit({Op::repeat_region, slot, 0, 0, 0});
}

std::uint8_t StatementParser::loop_number(Cursor& cursor) {
  const char* const begin = cursor.at();
  if (!is_digit(cursor.peek())) {
    fail(cursor, Code::illegal_loop_number, "1, 2 or 3 is expected here");
  }
  const NumberText text = cursor.number();
  emitter_.stand_at(begin, cursor.behind());
  if (text.point || text.value < 1 || text.value > 3) {
    throw SyntaxError{Code::illegal_loop_number, begin, cursor.length_since(begin), {}, {}};
  }
  return static_cast<std::uint8_t>(text.value);
}

// print = ("DPRNT"|"BPRNT") "[" { character | variable "[" digits "]" } "]"
void StatementParser::print(Cursor& cursor, StatementKind kind) {
  if (!cursor.take('[')) fail(cursor, Code::print_format, "'[' is expected here");
  const auto first = static_cast<std::uint32_t>(page_.print_items.size());
  while (cursor.peek() != ']') {
    if (cursor.done()) fail(cursor, Code::print_format, "the list is not closed");
    if (cursor.peek() == '#') {
      print_variable(cursor);
      continue;
    }
    if (!is_print_character(cursor.peek())) {
      fail(cursor, Code::print_format, "this character cannot be printed");
    }
    page_.print_items.push_back({.character = cursor.peek() == '*' ? ' ' : cursor.peek()});
    cursor.advance();
  }
  cursor.advance();
  host_statement(kind, first, static_cast<std::uint32_t>(page_.print_items.size()) - first);
}

void StatementParser::print_variable(Cursor& cursor) {
  Expression expression(cursor, emitter_, names_);
  const Operand value = expression.load(expression.variable());
  if (!cursor.take('[')) fail(cursor, Code::print_format, "the number of digits is missing");
  const char* const begin = cursor.at();
  PrintItem item{.register_ = value.reg};
  int count = 0;
  for (; is_digit(cursor.peek()); ++count) {
    item.integers = item.decimals;
    item.decimals = static_cast<std::uint8_t>(cursor.peek() - '0');
    cursor.advance();
  }
  const int digits = item.integers + item.decimals;
  if (count < 1 || count > 2 || digits < 1 || digits > kMostPrintDigits || cursor.peek() != ']') {
    throw SyntaxError{Code::print_format,
                      begin,
                      cursor.length_since(begin),
                      "at most 8 digits: integers, then decimals",
                      {}};
  }
  cursor.advance();
  page_.print_items.push_back(item);
}

// setvn = "SETVN" n "[" name { "," name } "]"
void StatementParser::name_variables(Cursor& cursor) {
  if (!is_digit(cursor.peek()))
    fail(cursor, Code::setvn_format, "a variable number is expected here");
  const double number = cursor.number().value;
  if (!cursor.take('[')) fail(cursor, Code::setvn_format, "'[' is expected here");
  const auto first = static_cast<std::uint32_t>(page_.variable_names.size());
  std::uint32_t count = 0;
  do {
    if (!nameable(number + count)) {
      fail(cursor, Code::setvn_format, "only #100 to #199 and #500 to #999 have names");
    }
    page_.variable_names.push_back(
        {static_cast<std::uint32_t>(number) + count, variable_name(cursor)});
    ++count;
  } while (cursor.take(','));
  if (!cursor.take(']')) fail(cursor, Code::setvn_format, "',' or ']' is expected here");
  host_statement(StatementKind::setvn, first, count);
}

std::string StatementParser::variable_name(Cursor& cursor) {
  const char* const begin = cursor.at();
  std::string name;
  for (char c = cursor.peek(); c != ',' && c != ']' && c != Cursor::kEnd; c = cursor.peek()) {
    const bool allowed = is_letter(c) || ((is_digit(c) || c == '_') && !name.empty());
    if (!allowed) fail(cursor, Code::setvn_character);
    name += c;
    cursor.advance();
  }
  const auto length = cursor.length_since(begin);
  if (name.empty()) fail(cursor, Code::setvn_format, "a name is expected here");
  if (name.size() > kLongestVariableName)
    throw SyntaxError{Code::setvn_length, begin, length, {}, {}};
  return name;
}

void StatementParser::host_statement(StatementKind kind, std::uint32_t first, std::uint32_t count) {
  const auto mark = static_cast<std::uint32_t>(page_.marks.size() - 1);
  page_.statements.push_back({.kind = kind, .first = first, .count = count, .mark = mark});
  emitter_.emit({Op::do_block, 0, 0, 0, static_cast<std::uint32_t>(page_.statements.size() - 1)});
}

}  // namespace kerf::gcode
