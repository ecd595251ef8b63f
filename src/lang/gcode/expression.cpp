#include "lang/gcode/expression.hpp"

#include <string>

namespace kerf::gcode {
namespace {

using base::Code;
using vm::Op;

constexpr int kBracketLevels = 5;  // docs/dialect.md §4.1
constexpr int kVariableDigits = 9;

bool is_comparison(Keyword keyword) { return keyword >= Keyword::eq && keyword <= Keyword::le; }
bool is_product(Keyword keyword) { return keyword == Keyword::and_ || keyword == Keyword::mod; }
bool is_sum(Keyword keyword) { return keyword == Keyword::or_ || keyword == Keyword::xor_; }

Op comparison_op(Keyword keyword) {
  switch (keyword) {
    case Keyword::eq: return Op::equal;
    case Keyword::ne: return Op::not_equal;
    case Keyword::lt: return Op::less;
    case Keyword::le: return Op::less_equal;
    case Keyword::gt: return Op::greater;
    default: return Op::greater_equal;
  }
}

Op shifted(Op op, Op from, Op to) {
  return static_cast<Op>(static_cast<int>(op) + static_cast<int>(to) - static_cast<int>(from));
}

bool is_comparison(Op op) { return op >= Op::equal && op <= Op::greater_equal; }

Function function_of(Keyword keyword) {
  switch (keyword) {
    case Keyword::sin: return Function::sin;
    case Keyword::cos: return Function::cos;
    case Keyword::tan: return Function::tan;
    case Keyword::asin: return Function::asin;
    case Keyword::acos: return Function::acos;
    case Keyword::sqrt: return Function::sqrt;
    case Keyword::abs: return Function::abs;
    case Keyword::bin: return Function::bin;
    case Keyword::bcd: return Function::bcd;
    case Keyword::fix: return Function::fix;
    case Keyword::fup: return Function::fup;
    case Keyword::ln: return Function::ln;
    case Keyword::exp: return Function::exp;
    case Keyword::adp: return Function::adp;
    case Keyword::and_: return Function::and_;
    case Keyword::or_: return Function::or_;
    case Keyword::xor_: return Function::xor_;
    case Keyword::mod: return Function::mod;
    default: return Function::round;
  }
}

Operand constant(double value) { return {.is_constant = true, .value = value}; }

Variable classify(std::uint32_t number) {
  if (number >= 1 && number < kLocals) return {Variable::Kind::local, number};
  if (number >= 100 && number <= 199) return {Variable::Kind::global, number - 100};
  if (number >= 500 && number <= 999) {
    return {Variable::Kind::global, number - 500 + kVolatileCommons};
  }
  return {Variable::Kind::fixed, number};
}

}  // namespace

void Expression::fail(Code code, std::string_view detail, std::string_view hint) const {
  throw SyntaxError{code, cursor_.at(), cursor_.done() ? 0U : 1U, detail, hint};
}

void Expression::fail_since(Code code, const char* begin, std::string_view detail) const {
  throw SyntaxError{code, begin, cursor_.length_since(begin), detail, {}};
}

Operand Expression::temporary(std::uint8_t reg, const char* begin, bool truth) const {
  return {.is_truth = truth, .reg = reg, .begin = begin, .end = cursor_.behind()};
}

void Expression::require_number(const Operand& operand) const {
  if (!operand.is_truth) return;
  throw SyntaxError{Code::expression_format,
                    operand.begin,
                    static_cast<std::size_t>(operand.end - operand.begin),
                    "a comparison is not a number",
                    {}};
}

KeywordMatch Expression::next_operator() const {
  if (!is_letter(cursor_.peek())) return {};
  return operator_at({cursor_.at(), static_cast<std::size_t>(cursor_.end() - cursor_.at())});
}

Operand Expression::number() {
  const Operand result = comparison();
  require_number(result);
  return result;
}

Operand Expression::bracketed_number() {
  const Operand result = bracketed();
  require_number(result);
  return result;
}

Operand Expression::bracketed_condition(Code format) {
  if (!cursor_.take('[')) fail(format, "a comparison in brackets is expected");
  const Operand result = comparison();
  if (is_comparison(next_operator().keyword)) fail(format, "comparisons cannot be chained");
  close_bracket();
  if (!result.is_truth) {
    throw SyntaxError{format,
                      result.begin,
                      static_cast<std::size_t>(result.end - result.begin),
                      "a comparison is expected",
                      {}};
  }
  return result;
}

// comparison = sum [ (EQ|NE|GT|GE|LT|LE) sum ]
Operand Expression::comparison() {
  const Operand left = sum();
  const KeywordMatch match = next_operator();
  if (!is_comparison(match.keyword)) return left;
  cursor_.advance(match.length);
  const Operand right = sum();
  require_number(left);
  require_number(right);
  const std::uint8_t x = in_register(left);
  const std::uint8_t y = in_register(right);
  const std::uint8_t result = result_register(emitter_, {.reg = x}, {.reg = y});
  stand_at(left.begin);
  emitter_.emit({comparison_op(match.keyword), result, x, y, 0});
  return temporary(result, left.begin, true);
}

// sum = term { (+|-|OR|XOR) term }
Operand Expression::sum() { return chain(&Expression::term, "+-", is_sum); }

// term = signed { (*|/|AND|MOD) signed }
Operand Expression::term() { return chain(&Expression::signed_operand, "*/", is_product); }

Operand Expression::chain(Rule operand, std::string_view signs, bool (*joins)(Keyword)) {
  Operand left = (this->*operand)();
  for (;;) {
    const char sign = cursor_.peek();
    const KeywordMatch match = next_operator();
    if (signs.find(sign) != std::string_view::npos) {
      cursor_.advance();
      const Operand right = (this->*operand)();
      left = arithmetic(sign, left, right);
    } else if (joins(match.keyword)) {
      cursor_.advance(match.length);
      const Operand right = (this->*operand)();
      left = logic(match.keyword, left, right);
    } else {
      return left;
    }
  }
}

Operand Expression::signed_operand() {
  const char* const begin = cursor_.at();
  bool negative = false;
  while (cursor_.peek() == '-' || cursor_.peek() == '+') {
    negative ^= cursor_.peek() == '-';
    cursor_.advance();
  }
  const Operand operand = primary();
  if (!negative) return operand;
  require_number(operand);
  return negated(operand, begin);
}

Operand Expression::negated(const Operand& operand, const char* begin) {
  Operand result = operand;
  result.begin = begin;
  result.value = -operand.value;
  if (operand.is_constant) return result;
  result.reg = result_register(emitter_, operand, operand);
  stand_at(begin);
  emitter_.emit({Op::negate, result.reg, operand.reg, 0, 0});
  return result;
}

Operand Expression::primary() {
  const char next = cursor_.peek();
  if (is_digit(next) || next == '.') return literal();
  if (next == '#') return load(variable());
  if (next == '[') return at_named_variable() ? load(named_variable()) : bracketed();
  if (is_letter(next)) {
    const char* const begin = cursor_.at();
    const KeywordMatch match =
        function_at({begin, static_cast<std::size_t>(cursor_.end() - begin)});
    if (match.keyword == Keyword::none) {
      if (is_letter(cursor_.peek_next())) fail(Code::undefined_word, "no function has this name");
      fail(Code::expression_format, "an address cannot stand in an expression");
    }
    cursor_.advance(match.length);
    return function(match.keyword, begin);
  }
  if (next == ']' && depth_ == 0) fail(Code::missing_open_bracket);
  if (!is_language_character(next))
    fail(Code::improper_address, "this character is not part of the language");
  fail(Code::expression_format, "an operand is missing");
}

Operand Expression::literal() {
  const char* const begin = cursor_.at();
  const NumberText text = cursor_.number();
  if (text.digits < 0)
    fail_since(Code::expression_format, begin, "a point without digits is no number");
  if (text.digits > kLiteralDigits) {
    fail_since(Code::too_many_digits, begin, "a number in a macro statement has at most 12 digits");
  }
  return {.is_constant = true, .value = text.value, .begin = begin, .end = cursor_.behind()};
}

void Expression::open_bracket() {
  if (++depth_ > kBracketLevels) fail(Code::brackets_too_deep, "more than five levels");
  cursor_.advance();
}

void Expression::close_bracket() {
  if (cursor_.done()) fail(Code::missing_close_bracket);
  if (!is_language_character(cursor_.peek())) {
    fail(Code::improper_address, "this character is not part of the language");
  }
  if (cursor_.peek() != ']') fail(Code::expression_format, "an operator or ']' is expected here");
  if (depth_ > 0) --depth_;
  cursor_.advance();
}

Operand Expression::bracketed() {
  const char* const begin = cursor_.at();
  open_bracket();
  Operand result = comparison();
  close_bracket();
  result.begin = begin;
  result.end = cursor_.behind();
  return result;
}

Operand Expression::function(Keyword keyword, const char* begin) {
  if (cursor_.peek() != '[') {
    fail(Code::expression_format, "the argument of a function stands in square brackets");
  }
  switch (keyword) {
    case Keyword::atan: return arc_tangent(begin);
    case Keyword::pow: return power();
    case Keyword::prm: return parameter(begin);
    case Keyword::round: return rounded(begin);
    default: return call(function_of(keyword), bracketed_number(), begin);
  }
}

Operand Expression::rounded(const char* begin) {
  const Operand argument = bracketed_number();
  if (address_ == 0) return call(Function::round, argument, begin);
  const std::uint8_t value = in_register(argument);
  const std::uint8_t increment = emitter_.allocate();
  stand_at(begin);
  emitter_.emit(
      {Op::read_fixed, increment, 0, 0, kIncrementOf + static_cast<std::uint32_t>(address_)});
  return call(Function::round_to, temporary(value, begin), temporary(increment, begin));
}

// ATAN[y], ATAN[y]/[x], ATAN[y,x]
Operand Expression::arc_tangent(const char* begin) {
  open_bracket();
  const Operand y = number();
  if (cursor_.take(',')) {
    const Operand x = number();
    close_bracket();
    return call(Function::atan2, y, x);
  }
  close_bracket();
  if (cursor_.peek() != '/') return call(Function::atan, y, begin);
  if (cursor_.peek_behind() != '[') {
    fail(Code::argument_format, "behind ATAN[ ] a '/' belongs to its second argument in brackets",
         "to divide the angle write [ATAN[…]]/…");
  }
  cursor_.advance();
  const Operand x = bracketed_number();
  return call(Function::atan2, y, x);
}

Operand Expression::power() {
  open_bracket();
  const Operand base_operand = number();
  if (cursor_.peek() == ']') fail(Code::argument_format, "POW has two arguments");
  if (!cursor_.take(',')) fail(Code::missing_comma, "POW has two arguments");
  const Operand exponent = number();
  close_bracket();
  return call(Function::pow, base_operand, exponent);
}

// PRM[n], PRM[n,bit], PRM[n]/[axis]; the suffix counts 1 + bit or 50 + axis.
Operand Expression::parameter(const char* begin) {
  open_bracket();
  Operand number_operand = number();
  number_operand.reg = in_register(number_operand);
  number_operand.is_constant = false;
  Operand suffix = constant(0);
  if (cursor_.take(',')) suffix = arithmetic('+', number(), constant(1));
  close_bracket();
  if (cursor_.peek() == '/' && cursor_.peek_behind() == '[') {
    cursor_.advance();
    suffix = arithmetic('+', bracketed_number(), constant(50));
  }
  const Operand address = call(Function::parameter, number_operand, suffix);
  const std::uint8_t result = result_register(emitter_, address, address);
  stand_at(begin);
  emitter_.emit({Op::read, result, address.reg, 0, 0});
  return temporary(result, begin);
}

Operand Expression::call(Function function, const Operand& argument, const char* begin) {
  const std::uint8_t reg = in_register(argument);
  const std::uint8_t result = result_register(emitter_, {.reg = reg}, {.reg = reg});
  stand_at(begin);
  emitter_.emit({Op::call_builtin, result, reg, 0, number_of(function)});
  return temporary(result, begin);
}

Operand Expression::call(Function function, const Operand& first, const Operand& second) {
  const char* const begin = first.begin != nullptr ? first.begin : second.begin;
  const std::uint8_t x = in_register(first);
  const std::uint8_t y = in_register(second);
  std::uint8_t arguments = x;
  if (y != x + 1) {
    arguments = emitter_.allocate();
    emitter_.emit({Op::move, arguments, x, 0, 0});
    emitter_.emit({Op::move, emitter_.allocate(), y, 0, 0});
  }
  const std::uint8_t result = result_register(emitter_, {.reg = x}, {.reg = y});
  stand_at(begin);
  emitter_.emit({Op::call_builtin, result, arguments, 0, number_of(function)});
  return temporary(result, begin);
}

// AND, OR, XOR, MOD. Between two comparisons the first three are logic (CTL-7).
Operand Expression::logic(Keyword keyword, const Operand& left, const Operand& right) {
  if (left.is_truth != right.is_truth || keyword == Keyword::mod) {
    require_number(left);
    require_number(right);
  }
  Operand result = call(function_of(keyword), left, right);
  result.is_truth = left.is_truth;
  return result;
}

Operand Expression::arithmetic(char sign, const Operand& left, const Operand& right) {
  require_number(left);
  require_number(right);
  const std::uint8_t x = in_register(left);
  Op op = Op::add;
  if (sign == '-') op = Op::subtract;
  if (sign == '*') op = Op::multiply;
  if (sign == '/') op = Op::divide;
  vm::Instruction instruction{op, 0, x, 0, 0};
  if (right.is_constant) {
    instruction.op = shifted(op, Op::add, Op::add_constant);
    instruction.n = emitter_.constant(right.value);
  } else {
    instruction.c = right.reg;
  }
  instruction.a = result_register(emitter_, {.reg = x}, right);
  stand_at(left.begin);
  emitter_.emit(instruction);
  return temporary(instruction.a, left.begin);
}

// The lower of the operands that are temporaries, or a new register; everything above it is free.
// variable = "#" ( digits | "[" expression "]" )
std::uint32_t Expression::branch(const Operand& condition, bool when) {
  vm::Instruction& last = emitter_.page().instructions.back();
  const auto expected = static_cast<std::uint8_t>(when ? 1 : 0);
  if (is_comparison(last.op) && last.a == condition.reg) {
    last.op = shifted(last.op, Op::equal, Op::branch_equal);
    last.a = expected;
    return emitter_.here() - 1;
  }
  return emitter_.emit({Op::branch, expected, condition.reg, 0, 0});
}

Variable Expression::variable() {
  const char* const begin = cursor_.at();
  cursor_.advance();
  if (is_digit(cursor_.peek())) {
    const NumberText text = cursor_.number();
    if (text.point)
      fail_since(Code::illegal_decimal_point, begin, "a variable number is an integer");
    if (text.digits > kVariableDigits) fail_since(Code::variable_range, begin);
    Variable result = classify(static_cast<std::uint32_t>(text.value));
    result.begin = begin;
    result.end = cursor_.behind();
    return result;
  }
  if (cursor_.peek() != '[') {
    fail(Code::expression_format, "a variable number or '[' belongs behind '#'",
         cursor_.peek() == '#' ? "write #[#5] instead of ##5" : "");
  }
  const char address = address_;
  address_ = 0;
  const Operand index = bracketed_number();
  address_ = address;
  return {Variable::Kind::computed, 0, in_register(index), begin, cursor_.behind()};
}

}  // namespace kerf::gcode
