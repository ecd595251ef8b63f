#include "lang/basic/expression.hpp"

#include <numbers>
#include <optional>

namespace kerf::basic {
namespace {

using base::Code;
using vm::Op;

constexpr double kDegreesOfRadian = 180 / std::numbers::pi;

std::optional<Op> comparison_of(const Token& token) {
  switch (token.delimiter) {
    case Delimiter::assign:
    case Delimiter::equal: return Op::equal;
    case Delimiter::not_equal: return Op::not_equal;
    case Delimiter::less: return Op::less;
    case Delimiter::greater: return Op::greater;
    case Delimiter::less_equal: return Op::less_equal;
    case Delimiter::greater_equal: return Op::greater_equal;
    default: return std::nullopt;
  }
}

bool is_comparison(Op op) { return op >= Op::equal && op <= Op::greater_equal; }

Op shifted(Op op, Op from, Op to) {
  return static_cast<Op>(static_cast<int>(op) - static_cast<int>(from) + static_cast<int>(to));
}

std::optional<Op> with_constant(Op op) {
  if (op < Op::add || op > Op::divide) return std::nullopt;
  return shifted(op, Op::add, Op::add_constant);
}

std::optional<Function> function_of(Word word) {
  if (word < Word::sin || word > Word::mod) return std::nullopt;
  return static_cast<Function>(static_cast<int>(word) - static_cast<int>(Word::sin));
}
static_assert(static_cast<int>(Word::mod) - static_cast<int>(Word::sin) ==
              static_cast<int>(Function::mod));

std::optional<Inquiry> inquiry_of(Word word) {
  switch (word) {
    case Word::xpos: return Inquiry::x;
    case Word::ypos: return Inquiry::y;
    case Word::zpos: return Inquiry::z;
    case Word::moved: return Inquiry::moved;
    default: return std::nullopt;
  }
}

std::uint32_t number(Inquiry inquiry) { return static_cast<std::uint32_t>(inquiry); }

}  // namespace

// How deep brackets, signs and functions may stand within each other: a bound of the stack.
class Expression::Level {
 public:
  explicit Level(Expression& expression) : depth_(expression.depth_) {
    constexpr int kDeepest = 1 + 200;  // the expression itself, and what stands within it
    if (depth_ == kDeepest) expression.tokens_.fail(Code::basic_syntax, kTooDeep);
    ++depth_;
  }
  ~Level() { --depth_; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  int& depth_;
};

Operand Expression::parse() {
  const Level level(*this);
  return disjunction();
}

// expr = conj { "OR" conj }
Operand Expression::disjunction() {
  Operand left = conjunction();
  while (tokens_.peek().is(Word::or_)) {
    const Token sign = tokens_.take();
    left = call(Function::or_, left, conjunction(), sign);
  }
  return left;
}

// conj = neg { "AND" neg }
Operand Expression::conjunction() {
  Operand left = negation();
  while (tokens_.peek().is(Word::and_)) {
    const Token sign = tokens_.take();
    left = call(Function::and_, left, negation(), sign);
  }
  return left;
}

// neg = "NOT" neg | rel
Operand Expression::negation() {
  if (!tokens_.peek().is(Word::not_)) return comparison();
  const Level level(*this);
  const Token sign = tokens_.take();
  const Operand operand = negation();
  return binary(Op::equal, operand, {.is_constant = true}, sign);
}

// rel = sum { ("=" | "==" | "<>" | "!=" | "<" | ">" | "<=" | ">=") sum }
Operand Expression::comparison() {
  Operand left = sum();
  while (const auto op = comparison_of(tokens_.peek())) {
    const Token sign = tokens_.take();
    left = binary(*op, left, sum(), sign);
  }
  return left;
}

// sum = term { ("+" | "-") term }
Operand Expression::sum() {
  Operand left = term();
  while (tokens_.peek().is(Delimiter::plus) || tokens_.peek().is(Delimiter::minus)) {
    const Token sign = tokens_.take();
    left = binary(sign.is(Delimiter::plus) ? Op::add : Op::subtract, left, term(), sign);
  }
  return left;
}

// term = unary { ("*" | "/" | "%") unary }
Operand Expression::term() {
  Operand left = unary();
  for (;;) {
    const Delimiter next = tokens_.peek().delimiter;
    if (next != Delimiter::times && next != Delimiter::divide && next != Delimiter::modulo)
      return left;
    const Token sign = tokens_.take();
    const Operand right = unary();
    left = next == Delimiter::modulo
               ? call(Function::remainder, left, right, sign)
               : binary(next == Delimiter::times ? Op::multiply : Op::divide, left, right, sign);
  }
}

// unary = ("-" | "+") unary | power
Operand Expression::unary() {
  const bool minus = tokens_.peek().is(Delimiter::minus);
  if (!minus && !tokens_.peek().is(Delimiter::plus)) return power();
  const Level level(*this);
  const Token sign = tokens_.take();
  const std::uint32_t mark = emitter_.mark();
  const Operand operand = unary();
  if (!minus) return operand;
  if (operand.is_constant) return {.is_constant = true, .value = -operand.value};
  emitter_.stand_at(sign.begin, sign.end);
  const std::uint8_t result = result_register(mark);
  emitter_.emit({Op::negate, result, operand.reg, 0, 0});
  return {.reg = result};
}

// power = atom [ "^" unary ]
Operand Expression::power() {
  const Operand left = atom();
  if (!tokens_.peek().is(Delimiter::power)) return left;
  const Level level(*this);
  const Token sign = tokens_.take();
  return call(Function::power, left, unary(), sign);
}

// atom = NUMBER | VARIABLE | "(" expr ")" | FUNCTION "(" [ expr { "," expr } ] ")" | FUNCTION0
Operand Expression::atom() {
  const Token& next = tokens_.peek();
  switch (next.type) {
    case TokenType::number: return {.is_constant = true, .value = tokens_.take().number};
    case TokenType::variable: return variable(tokens_.take());
    case TokenType::command:
      if (is_function(next.word)) return function();
      break;
    case TokenType::delimiter:
      if (next.is(Delimiter::open)) return bracketed();
      if (next.is(Delimiter::close) || next.is(Delimiter::comma) || next.is(Delimiter::semicolon))
        tokens_.fail(Code::basic_no_expression);
      break;
    case TokenType::finished: tokens_.fail(Code::basic_no_expression);
    case TokenType::wrong: tokens_.fail(next.mistake);
    default: break;
  }
  tokens_.fail(Code::basic_syntax, "a number, a variable or a function is expected here");
}

Operand Expression::bracketed() {
  const Token open = tokens_.take();
  const Operand inner = parse();
  if (!tokens_.take(Delimiter::close))
    throw SyntaxError{Code::basic_brackets, open.begin, open.end, "this one is not closed"};
  return inner;
}

Operand Expression::function() {
  const Token name = tokens_.take();
  if (const auto inquiry = inquiry_of(name.word)) {
    if (tokens_.take(Delimiter::open) && !tokens_.take(Delimiter::close))
      throw SyntaxError{Code::basic_argument_count, name.begin, name.end,
                        name.text + " takes no argument"};
    return inquire(*inquiry, name);
  }
  return arguments_of(name.word, name);
}

// Into consecutive registers, but for a single one, which is taken where it is.
Operand Expression::arguments_of(Word word, const Token& name) {
  if (!tokens_.peek().is(Delimiter::open))
    tokens_.fail(Code::basic_syntax, "'(' is expected behind " + name.text);
  const Token open = tokens_.take();
  const std::uint32_t mark = emitter_.mark();
  auto first = static_cast<std::uint8_t>(mark);
  std::size_t count = 0;
  if (!tokens_.peek().is(Delimiter::close)) {
    const Operand argument = parse();
    ++count;
    if (tokens_.peek().is(Delimiter::close)) {
      first = in_register(argument);
    } else {
      move_to(result_register(mark), argument);
    }
    for (; tokens_.take(Delimiter::comma); ++count) parse_into_next();
  }
  if (!tokens_.take(Delimiter::close))
    throw SyntaxError{Code::basic_brackets, open.begin, open.end, "this one is not closed"};
  if (word == Word::dist) return distance(first, count, name);
  const std::optional<Function> function = function_of(word);
  const std::size_t wanted = function ? builtin_table()[basic::number_of(*function)].arguments : 1;
  if (count != wanted)
    throw SyntaxError{Code::basic_argument_count, name.begin, name.end,
                      name.text + (wanted == 1 ? " takes one" : " takes two")};
  emitter_.stand_at(name.begin, name.end);
  const std::uint8_t result = result_register(mark);
  if (function) {
    emitter_.emit({Op::call_builtin, result, first, 0, basic::number_of(*function)});
  } else {
    const Op op = word == Word::deg ? Op::multiply_constant : Op::divide_constant;
    emitter_.emit({op, result, first, 0, emitter_.constant(kDegreesOfRadian)});
  }
  return {.reg = result};
}

// From the recorded position: DIST(x, y[, z]).
Operand Expression::distance(std::uint8_t first, std::size_t count, const Token& name) {
  if (count != 2 && count != 3)
    throw SyntaxError{Code::basic_argument_count, name.begin, name.end,
                      name.text + " takes two or three"};
  emitter_.stand_at(name.begin, name.end);
  if (count == 2) emitter_.emit({Op::read_fixed, emitter_.allocate(), 0, 0, number(Inquiry::z)});
  for (const Inquiry inquiry : {Inquiry::x, Inquiry::y, Inquiry::z})
    emitter_.emit({Op::read_fixed, emitter_.allocate(), 0, 0, number(inquiry)});
  const std::uint8_t result = result_register(first);
  emitter_.emit({Op::call_builtin, result, first, 0, basic::number_of(Function::distance)});
  return {.reg = result};
}

Operand Expression::inquire(Inquiry inquiry, const Token& name) {
  emitter_.stand_at(name.begin, name.end);
  const std::uint8_t result = emitter_.allocate();
  emitter_.emit({Op::read_fixed, result, 0, 0, number(inquiry)});
  return {.reg = result};
}

std::uint32_t Expression::number_of(const Token& name) const {
  return emitter_.scan().variables.at(name.text);
}

// What has perhaps not been written yet is asked of the host, which tells so.
Operand Expression::variable(const Token& name) {
  const std::uint32_t number = number_of(name);
  emitter_.stand_at(name.begin, name.end);
  if (number >= kNear) {
    const std::uint8_t reg = emitter_.allocate();
    emitter_.emit({Op::load_global, reg, 0, 0, number - kNear});
    emitter_.emit({Op::read_if_null, reg, 0, 0, number});
    return {.reg = reg};
  }
  const auto reg = static_cast<std::uint8_t>(number);
  if (!emitter_.knows(number)) emitter_.emit({Op::read_if_null, reg, 0, 0, number});
  emitter_.know(number);
  return {.reg = reg};
}

// Operands

std::uint8_t Expression::in_register(const Operand& operand) {
  if (!operand.is_constant) return operand.reg;
  const std::uint8_t reg = emitter_.allocate();
  emitter_.emit({Op::load_constant, reg, 0, 0, emitter_.constant(operand.value)});
  return reg;
}

// The first register from `free_from` on; everything above it is free. What is worked out from
// there on must have been used.
std::uint8_t Expression::result_register(std::uint32_t free_from) {
  emitter_.release_from(free_from);
  return emitter_.allocate();
}

Operand Expression::binary(Op op, const Operand& left, const Operand& right, const Token& sign) {
  emitter_.stand_at(sign.begin, sign.end);
  const auto is_free = [](const Operand& operand) {
    return !operand.is_constant && Emitter::is_temporary(operand.reg);
  };
  std::uint32_t lowest = emitter_.mark();
  if (is_free(right)) lowest = right.reg;
  if (is_free(left) && left.reg < lowest) lowest = left.reg;
  const std::uint8_t x = in_register(left);
  const auto short_form = right.is_constant ? with_constant(op) : std::nullopt;
  if (short_form) {
    const std::uint32_t constant = emitter_.constant(right.value);
    const std::uint8_t result = result_register(lowest);
    emitter_.emit({*short_form, result, x, 0, constant});
    return {.reg = result};
  }
  const std::uint8_t y = in_register(right);
  const std::uint8_t result = result_register(lowest);
  emitter_.emit({op, result, x, y, 0});
  return {.reg = result};
}

Operand Expression::call(Function function, const Operand& left, const Operand& right,
                         const Token& sign) {
  emitter_.stand_at(sign.begin, sign.end);
  const std::uint8_t first = emitter_.allocate();
  move_to(first, left);
  move_to(emitter_.allocate(), right);
  std::uint32_t lowest = first;
  for (const Operand& operand : {left, right}) {
    if (!operand.is_constant && Emitter::is_temporary(operand.reg) && operand.reg < lowest)
      lowest = operand.reg;
  }
  const std::uint8_t result = result_register(lowest);
  emitter_.emit({Op::call_builtin, result, first, 0, basic::number_of(function)});
  return {.reg = result};
}

void Expression::move_to(std::uint8_t reg, const Operand& operand) {
  if (operand.is_constant) {
    emitter_.emit({Op::load_constant, reg, 0, 0, emitter_.constant(operand.value)});
  } else if (operand.reg != reg) {
    emitter_.emit({Op::move, reg, operand.reg, 0, 0});
  }
}

std::uint8_t Expression::parse_into_next() {
  const std::uint32_t mark = emitter_.mark();
  const Operand value = parse();
  const std::uint8_t reg = result_register(mark);
  move_to(reg, value);
  return reg;
}

// A comparison that was compiled last, and whose result nothing else wants, becomes the branch
// itself.
std::uint32_t Expression::branch(const Operand& condition, bool when) {
  const auto expected = static_cast<std::uint8_t>(when ? 1 : 0);
  if (!condition.is_constant && Emitter::is_temporary(condition.reg) &&
      !emitter_.page().instructions.empty()) {
    vm::Instruction& last = emitter_.page().instructions.back();
    if (is_comparison(last.op) && last.a == condition.reg) {
      last.op = shifted(last.op, Op::equal, Op::branch_equal);
      last.a = expected;
      return emitter_.here() - 1;
    }
  }
  return emitter_.emit({Op::branch, expected, in_register(condition), 0, 0});
}

void Expression::store(std::uint32_t variable, const Operand& value) {
  if (variable >= kNear) {
    emitter_.emit({Op::store_global, in_register(value), 0, 0, variable - kNear});
    return;
  }
  const auto reg = static_cast<std::uint8_t>(variable);
  vm::Instruction* const last =
      emitter_.page().instructions.empty() ? nullptr : &emitter_.page().instructions.back();
  const bool just_made =
      last != nullptr && !value.is_constant && Emitter::is_temporary(value.reg) &&
      last->a == value.reg &&
      ((last->op >= Op::negate && last->op <= Op::greater_equal) || last->op == Op::call_builtin);
  if (just_made) {
    last->a = reg;
  } else {
    move_to(reg, value);
  }
  emitter_.know(variable);
}

}  // namespace kerf::basic
