#include "lang/basic/line_compiler.hpp"

#include <optional>
#include <utility>

namespace kerf::basic {
namespace {

using base::Code;
using vm::Op;

// A PRINT with more numbers than this is executed in parts: their registers are needed again.
constexpr std::uint32_t kPrintRegisters = 16;

struct MachineStatement {
  StatementKind kind;
  std::size_t least, most;  // arguments
};

std::optional<MachineStatement> machine_statement_of(Word word) {
  switch (word) {
    case Word::speed: return MachineStatement{StatementKind::speed, 1, 1};
    case Word::power: return MachineStatement{StatementKind::power, 1, 1};
    case Word::move: return MachineStatement{StatementKind::move, 2, 3};
    case Word::line: return MachineStatement{StatementKind::line, 2, 3};
    case Word::circle: return MachineStatement{StatementKind::circle, 3, 4};
    case Word::arc: return MachineStatement{StatementKind::arc, 4, 6};
    case Word::wait: return MachineStatement{StatementKind::wait, 1, 1};
    case Word::burn: return MachineStatement{StatementKind::burn, 1, 1};
    case Word::pulse: return MachineStatement{StatementKind::pulse, 2, 2};
    case Word::air: return MachineStatement{StatementKind::air, 1, 1};
    default: return std::nullopt;
  }
}

std::string range_text(const MachineStatement& statement) {
  const std::string least = std::to_string(statement.least);
  return statement.least == statement.most ? least
                                           : least + " to " + std::to_string(statement.most);
}

}  // namespace

void LineCompiler::compile(const Line& line) {
  line_ = line;
  emitter_.begin_block(line.text.data());
  TokenStream tokens(line.text);
  label(tokens);
  statements(tokens, Within::line);
}

void LineCompiler::fail_long_line(const Line& line) {
  line_ = line;
  static constexpr char kNothing[] = "";
  emitter_.begin_block(kNothing);
  Token first;
  first.begin = first.end = kNothing;
  begin_statement(first);
  report({Code::block_too_long, kNothing, kNothing, {}});
}

// label = NUMBER | IDENT ":"; only at the start of a line
void LineCompiler::label(TokenStream& tokens) {
  const Token& first = tokens.peek();
  const auto begin = static_cast<std::size_t>(first.begin - line_.text.data());
  std::string name;
  if (first.type == TokenType::number) name = label_name(first.number);
  if (first.type == TokenType::variable) {
    TokenStream ahead(line_.text.substr(begin));
    const Token word = ahead.take();
    if (ahead.peek().is(Delimiter::colon)) name = word.text;
  }
  if (name.empty()) return;
  const bool named = first.type == TokenType::variable;
  tokens.take();
  if (named) tokens.take();
  page_.labels.push_back({emitter_.scan().labels.at(name).number, emitter_.here()});
  emitter_.know_little();
  begin_stretch();
}

// { stmt-or-empty ";" }
void LineCompiler::statements(TokenStream& tokens, Within within) {
  const auto is_over = [&] {
    return tokens.at_end() || (within == Within::condition && tokens.peek().is(Word::else_));
  };
  while (!is_over()) {
    if (tokens.take(Delimiter::semicolon)) continue;
    statement(tokens, within);
  }
}

void LineCompiler::statement(TokenStream& tokens, Within within) {
  begin_statement(tokens.peek());
  const std::size_t mark = page_.marks.size() - 1;
  const char* const begin = tokens.peek().begin;
  attempt(tokens, within, [&] {
    command(tokens, tokens.take());
    expect_end(tokens);
  });
  page_.marks[mark].length = static_cast<std::uint32_t>(tokens.behind() - begin);
}

void LineCompiler::expect_end(const TokenStream& tokens) {
  if (!tokens.at_end_of_statement())
    tokens.unexpected(Code::basic_syntax, "the statement should end here");
}

template <typename Part>
void LineCompiler::attempt(TokenStream& tokens, Within within, const Part& part) {
  try {
    part();
  } catch (const SyntaxError& error) {
    report(error);
    leave(tokens, within);
  }
}

// A mistake ends the line, up to the ELSE that belongs to an IF before it. A loop without a pass
// whose NEXT is left out comes upon the mistake.
void LineCompiler::leave(TokenStream& tokens, Within within) {
  const std::uint32_t mistake = emitter_.here() - 1;
  for (int depth = std::exchange(unread_ifs_, 0); !tokens.at_end(); tokens.take()) {
    const Token& next = tokens.peek();
    depth += next.is(Word::if_);
    if (next.is(Word::else_) && depth-- == 0 && within == Within::condition) return;
    loops_ += next.is(Word::for_);
    if (next.is(Word::next))
      page_.labels.push_back({emitter_.scan().label_behind(nexts_++), mistake});
  }
}

void LineCompiler::begin_statement(const Token& first) {
  const auto within =
      static_cast<std::uint32_t>(line_.text.empty() ? 0 : first.begin - line_.text.data());
  page_.marks.push_back({emitter_.here(), line_.number, line_.offset + within, line_.offset, 0, 0});
  emitter_.release_from(kNear);
  emitter_.stand_at(first.begin, first.end);
  if (steps_ == kNoSteps) steps_ = emitter_.emit({Op::count_steps, 0, 0, 0, 0});
  ++page_.instructions[steps_].n;
}

void LineCompiler::report(const SyntaxError& error) {
  emitter_.stand_at(error.begin, error.end);
  const vm::Span span = vm::Span::between(error.begin, error.end, emitter_.line_text());
  const base::Place place{.file = page_.file,
                          .line = line_.number,
                          .column = span.column,
                          .length = span.length,
                          .line_start = page_.text_begin + line_.offset};
  emitter_.emit({Op::fail, 0, 0, 0, static_cast<std::uint32_t>(page_.failures.size())});
  page_.failures.push_back(base::make_error(error.code, place, error.detail));
}

void LineCompiler::command(TokenStream& tokens, const Token& first) {
  if (first.type == TokenType::variable) return assignment(tokens, first);
  if (first.type == TokenType::wrong) throw SyntaxError{first.mistake, first.begin, first.end};
  switch (first.word) {
    case Word::let: return let(tokens);
    case Word::print: return print(tokens, first);
    case Word::input: return input(tokens, first);
    case Word::if_: return if_statement(tokens);
    case Word::for_: return for_statement(tokens, first);
    case Word::next: return next(tokens, first);
    case Word::go_to: return jump(tokens, Op::jump_to_label, first);
    case Word::gosub: return jump(tokens, Op::call_label, first);
    case Word::return_: return return_from_call(tokens, first);
    case Word::local: return local(tokens, first);
    case Word::end: expect_end(tokens); return host_statement(first, StatementKind::end, 0, 0);
    case Word::home:
      if (tokens.take(Delimiter::open) && !tokens.take(Delimiter::close))
        throw SyntaxError{Code::basic_argument_count, first.begin, first.end,
                          "HOME takes no argument"};
      expect_end(tokens);
      return host_statement(first, StatementKind::home, 0, 0);
    default: break;
  }
  if (machine_statement_of(first.word)) return machine_statement(tokens, first);
  throw SyntaxError{Code::basic_syntax, first.begin, first.end, "no statement begins with this"};
}

// [ "LET" ] VARIABLE "=" expr
void LineCompiler::assignment(TokenStream& tokens, const Token& name) {
  if (!tokens.peek().is(Delimiter::assign)) {
    const Token& next = tokens.peek();
    const bool sign = next.type == TokenType::delimiter && !next.is(Delimiter::open) &&
                      !next.is(Delimiter::semicolon);
    if (sign) tokens.fail(Code::basic_equals);
    throw SyntaxError{Code::basic_unknown_command, name.begin, name.end, name.text};
  }
  tokens.take();
  Expression expression(tokens, emitter_);
  const Operand value = expression.parse();
  expect_end(tokens);
  emitter_.stand_at(name.begin, tokens.behind());
  expression.store(expression.number_of(name), value);
}

void LineCompiler::let(TokenStream& tokens) {
  if (tokens.peek().type != TokenType::variable) tokens.fail(Code::basic_variable);
  const Token name = tokens.take();
  if (!tokens.peek().is(Delimiter::assign)) tokens.fail(Code::basic_equals);
  assignment(tokens, name);
}

// "PRINT" [ item { ("," | ";") [ item ] } ]; the last statement of its line
void LineCompiler::print(TokenStream& tokens, const Token& first) {
  first_item_ = static_cast<std::uint32_t>(page_.items.size());
  const auto is_over = [&] { return tokens.at_end() || tokens.peek().is(Word::else_); };
  bool separated = true;
  while (!is_over()) {
    const bool comma = tokens.peek().is(Delimiter::comma);
    if (comma || tokens.peek().is(Delimiter::semicolon)) {
      page_.items.push_back({comma ? PrintItem::Kind::comma : PrintItem::Kind::semicolon, 0, 0});
      tokens.take();
      separated = true;
      continue;
    }
    if (!separated) tokens.unexpected(Code::basic_syntax, "',' or ';' is expected here");
    print_item(tokens);
    separated = false;
    if (emitter_.mark() >= kNear + kPrintRegisters) flush_print(first, true);
  }
  const bool trailing = page_.items.size() > first_item_ && separated;
  if (!trailing) page_.items.push_back({});
  flush_print(first, false);
}

// item = QUOTE | expr
void LineCompiler::print_item(TokenStream& tokens) {
  if (tokens.peek().type == TokenType::quote) {
    page_.items.push_back({PrintItem::Kind::text, 0, text(tokens.take().text)});
    return;
  }
  const std::uint8_t reg = Expression(tokens, emitter_).parse_into_next();
  page_.items.push_back({PrintItem::Kind::number, reg, 0});
}

void LineCompiler::flush_print(const Token& first, bool goes_on) {
  const auto count = static_cast<std::uint32_t>(page_.items.size()) - first_item_;
  host_statement(first, StatementKind::print, first_item_, count, goes_on);
  first_item_ += count;
  emitter_.release_from(kNear);
}

// "INPUT" [ QUOTE "," ] VARIABLE
void LineCompiler::input(TokenStream& tokens, const Token& first) {
  std::string prompt = "? ";
  if (tokens.peek().type == TokenType::quote) {
    prompt = tokens.take().text;
    if (!tokens.take(Delimiter::comma)) tokens.fail(Code::basic_syntax, "',' is expected here");
  }
  if (tokens.peek().type != TokenType::variable) tokens.fail(Code::basic_variable);
  const Token name = tokens.take();
  expect_end(tokens);
  const auto item = static_cast<std::uint32_t>(page_.items.size());
  page_.items.push_back({PrintItem::Kind::text, 0, text(prompt)});
  host_statement(first, StatementKind::prompt, item, 1);
  const std::uint8_t reg = emitter_.allocate();
  emitter_.emit({Op::read_fixed, reg, 0, 0, static_cast<std::uint32_t>(Inquiry::input)});
  Expression expression(tokens, emitter_);
  expression.store(expression.number_of(name), {.reg = reg});
}

// "IF" expr ( "THEN" ( NUMBER | stmts ) | "GOTO" ref ) [ "ELSE" ( NUMBER | stmts ) ]
void LineCompiler::if_statement(TokenStream& tokens) {
  constexpr int kMostIfs = 100;
  ++unread_ifs_;
  if (ifs_ == kMostIfs) tokens.fail(Code::basic_syntax, "there are too many IFs on this line");
  Expression expression(tokens, emitter_);
  const Operand condition = expression.parse();
  if (!tokens.peek().is(Word::then) && !tokens.peek().is(Word::go_to))
    tokens.unexpected(Code::basic_then);
  const std::uint32_t when_false = expression.branch(condition, false);
  unread_ifs_ = 0;
  Emitter::Known known = emitter_.known();
  tokens.take(Word::then);
  ++ifs_;
  branch_of_if(tokens);
  std::swap(known, emitter_.known());
  if (tokens.take(Word::else_)) {
    const std::uint32_t when_true = emitter_.emit({Op::jump, 0, 0, 0, 0});
    emitter_.land(when_false);
    branch_of_if(tokens);
    emitter_.land(when_true);
  } else {
    emitter_.land(when_false);
  }
  --ifs_;
  emitter_.known() &= known;  // written on both ways
  begin_stretch();
}

// NUMBER is a label to go to.
void LineCompiler::branch_of_if(TokenStream& tokens) {
  begin_stretch();
  if (tokens.peek().type == TokenType::number) {
    const Token target = tokens.peek();
    begin_statement(target);
    attempt(tokens, Within::condition, [&] { jump(tokens, Op::jump_to_label, target); });
  }
  statements(tokens, Within::condition);
}

// "FOR" VARIABLE "=" expr "TO" expr [ "STEP" expr ]
void LineCompiler::for_statement(TokenStream& tokens, const Token& first) {
  const std::uint32_t loop = loops_++;
  if (tokens.peek().type != TokenType::variable) tokens.fail(Code::basic_variable);
  const Token name = tokens.take();
  if (!tokens.take(Delimiter::assign)) tokens.fail(Code::basic_equals);
  Expression expression(tokens, emitter_);
  const std::uint8_t from = expression.parse_into_next();
  if (!tokens.take(Word::to)) tokens.unexpected(Code::basic_to);
  expression.parse_into_next();
  Token step = first;
  if (tokens.take(Word::step)) {
    step = tokens.peek();
    expression.parse_into_next();
  } else {
    const std::uint8_t one = emitter_.allocate();
    emitter_.emit({Op::load_constant, one, 0, 0, emitter_.constant(1)});
  }
  expect_end(tokens);
  const std::uint32_t variable = expression.number_of(name);
  // LB0022 stands at the step, LB0010 at it too where one is written.
  emitter_.stand_at(step.begin, step.end);
  emitter_.emit({Op::open_loop, from, 0, 0, Emitter::slot_of(variable)});
  emitter_.emit({Op::jump_to_label, 0, 0, 1,
                 emitter_.scan().label_behind(emitter_.scan().next_of_loop[loop])});
  emitter_.know(variable);
  begin_stretch();
}

// "NEXT" [ VARIABLE ]
void LineCompiler::next(TokenStream& tokens, const Token& first) {
  const std::uint32_t number = nexts_++;
  std::uint32_t slot = vm::kAnyLoop;
  if (tokens.peek().type == TokenType::variable) {
    const Token name = tokens.take();
    slot = Emitter::slot_of(Expression(tokens, emitter_).number_of(name));
  }
  const std::uint32_t behind = emitter_.scan().label_behind(number);
  if (!tokens.at_end_of_statement()) page_.labels.push_back({behind, emitter_.here()});
  expect_end(tokens);
  emitter_.stand_at(first.begin, first.end);
  emitter_.emit({Op::repeat_loop, 0, 0, 0, slot});
  page_.labels.push_back({behind, emitter_.here()});
  emitter_.know_little();
  begin_stretch();
}

// ref = NUMBER | IDENT
void LineCompiler::jump(TokenStream& tokens, Op op, const Token& first) {
  const TokenType type = tokens.peek().type;
  if (type != TokenType::number && type != TokenType::variable)
    tokens.fail(Code::basic_syntax, "a label is expected here");
  const Token target = tokens.take();
  expect_end(tokens);
  jump_to(target, op, first);
}

void LineCompiler::jump_to(const Token& target, Op op, const Token& first) {
  const std::string name =
      target.type == TokenType::number ? label_name(target.number) : target.text;
  const auto label = emitter_.scan().labels.find(name);
  if (label == emitter_.scan().labels.end())
    throw SyntaxError{Code::basic_undefined_label, target.begin, target.end, name};
  emitter_.stand_at(first.begin, first.end);
  emitter_.emit({op, 0, 0, 1, label->second.number});
  // What was LOCAL may be vacant again behind a call.
  if (op == Op::call_label) emitter_.know_little();
  begin_stretch();
}

void LineCompiler::return_from_call(const TokenStream& tokens, const Token& first) {
  expect_end(tokens);
  emitter_.stand_at(first.begin, first.end);
  emitter_.emit({Op::leave_call, 0, 0, 0, 0});
  begin_stretch();
}

// "LOCAL" VARIABLE { "," VARIABLE }
void LineCompiler::local(TokenStream& tokens, const Token& first) {
  std::vector<std::uint32_t> variables;
  do {
    if (tokens.peek().type != TokenType::variable) tokens.fail(Code::basic_variable);
    const Token name = tokens.take();
    variables.push_back(Expression(tokens, emitter_).number_of(name));
  } while (tokens.take(Delimiter::comma));
  expect_end(tokens);
  emitter_.stand_at(first.begin, first.end);
  for (const std::uint32_t variable : variables)
    emitter_.emit({Op::save_variable, 0, 0, 0, Emitter::slot_of(variable)});
}

// ( "SPEED" | "POWER" | "MOVE" | "LINE" | "ARC" | "CIRCLE" | "WAIT" | "BURN" |
//   "PULSE" | "AIR" ) "(" expr { "," expr } ")"
void LineCompiler::machine_statement(TokenStream& tokens, const Token& first) {
  const MachineStatement statement = *machine_statement_of(first.word);
  if (!tokens.peek().is(Delimiter::open))
    tokens.fail(Code::basic_syntax, "'(' is expected behind " + first.text);
  const Token open = tokens.take();
  Expression expression(tokens, emitter_);
  std::uint32_t begin = 0;
  std::size_t count = 0;
  if (!tokens.peek().is(Delimiter::close)) {
    do {
      const std::uint32_t reg = expression.parse_into_next();
      if (count++ == 0) begin = reg;
    } while (tokens.take(Delimiter::comma));
  }
  if (!tokens.take(Delimiter::close))
    throw SyntaxError{Code::basic_brackets, open.begin, open.end, "this one is not closed"};
  if (count < statement.least || count > statement.most)
    throw SyntaxError{Code::basic_argument_count, first.begin, first.end,
                      first.text + " takes " + range_text(statement)};
  expect_end(tokens);
  host_statement(first, statement.kind, begin, static_cast<std::uint32_t>(count));
}

void LineCompiler::host_statement(const Token& first, StatementKind kind, std::uint32_t begin,
                                  std::uint32_t count, bool goes_on) {
  emitter_.stand_at(first.begin, first.end);
  emitter_.emit({Op::do_block, 0, 0, 0, static_cast<std::uint32_t>(page_.statements.size())});
  page_.statements.push_back({kind, begin, count, goes_on});
}

std::uint32_t LineCompiler::text(const std::string& text) {
  page_.texts.push_back(text);
  return static_cast<std::uint32_t>(page_.texts.size() - 1);
}

}  // namespace kerf::basic
