// Variables in expressions: their numbers and names, and how their values get in and out.
#include <string>

#include "lang/gcode/expression.hpp"
#include "lang/gcode/system_names.hpp"

namespace kerf::gcode {
namespace {

using base::Code;
using vm::Op;

constexpr int kVariableDigits = 9;
constexpr std::size_t kLongestName = 8;
constexpr std::size_t kLongestSystemName = 31;

// Instructions whose register `a` is nothing but their result.
bool makes_result(Op op) {
  return (op >= Op::load_constant && op <= Op::load_global) || op == Op::read ||
         op == Op::read_fixed || (op >= Op::negate && op <= Op::greater_equal) ||
         op == Op::call_builtin;
}

Variable classify(std::uint32_t number) {
  if (number >= 1 && number < kLocals) return {Variable::Kind::local, number};
  if (number >= 100 && number <= 199) return {Variable::Kind::global, number - 100};
  if (number >= 500 && number <= 999) {
    return {Variable::Kind::global, number - 500 + kVolatileCommons};
  }
  return {Variable::Kind::fixed, number};
}

}  // namespace

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

bool Expression::at_named_variable() const {
  Cursor ahead = cursor_;
  ahead.advance();
  if (ahead.peek() != '#') return false;
  const char first = ahead.peek_behind();
  return is_letter(first) || first == '_';
}

// named = "[#" name [ "[" index "]" ] "]"
Variable Expression::named_variable() {
  const char* const begin = cursor_.at();
  cursor_.advance();
  cursor_.advance();
  std::string name;
  for (char c = cursor_.peek(); is_letter(c) || is_digit(c) || c == '_'; c = cursor_.peek()) {
    name += c;
    cursor_.advance();
  }
  if (name.size() > (name[0] == '_' ? kLongestSystemName : kLongestName)) {
    fail_since(Code::variable_name_long, begin);
  }
  Variable result{Variable::Kind::fixed, 0, 0, begin, begin};
  result.number = name[0] == '_' ? system_variable(name, begin) : kNamed + names_.number_of(name);
  if (cursor_.done()) fail(Code::missing_close_bracket);
  if (!cursor_.take(']')) fail(Code::variable_name, "a name has letters, digits and underscores");
  result.end = cursor_.behind();
  return result;
}

std::uint32_t Expression::system_variable(const std::string& name, const char* begin) {
  const auto known = system_name(name);
  if (!known) fail_since(Code::variable_name_unknown, begin);
  double index = known->lowest_index;
  if (cursor_.peek() == '[') {
    if (!known->indexed) fail(Code::variable_suffix, "this variable has no index");
    cursor_.advance();
    if (!is_digit(cursor_.peek())) fail(Code::variable_suffix, "the index is a number");
    index = cursor_.number().value;
    if (!cursor_.take(']')) fail(Code::missing_close_bracket);
  } else if (known->indexed) {
    fail(Code::variable_suffix, "this variable needs an index");
  }
  const double offset = index - known->lowest_index;
  if (!(offset >= 0 && offset < known->count)) fail_since(Code::variable_suffix, begin);
  return known->first + static_cast<std::uint32_t>(offset);
}

Operand Expression::load(const Variable& variable) {
  Operand result{.begin = variable.begin, .end = variable.end};
  const bool is_null = variable.kind == Variable::Kind::fixed && variable.number == 0;
  if (variable.kind == Variable::Kind::local || is_null) {
    result.reg = static_cast<std::uint8_t>(variable.number);
    return result;
  }
  emitter_.stand_at(variable.begin, variable.end);
  if (variable.kind == Variable::Kind::computed) {
    result.reg = result_register({.reg = variable.reg}, {.reg = variable.reg});
    emitter_.emit({Op::read, result.reg, variable.reg, 0, 0});
    return result;
  }
  result.reg = emitter_.allocate();
  const Op op = variable.kind == Variable::Kind::global ? Op::load_global : Op::read_fixed;
  emitter_.emit({op, result.reg, 0, 0, variable.number});
  return result;
}

void Expression::store(const Variable& variable, const Operand& operand) {
  auto& instructions = emitter_.page().instructions;
  if (variable.kind == Variable::Kind::local) {
    const auto target = static_cast<std::uint8_t>(variable.number);
    if (operand.is_constant) {
      emitter_.emit({Op::load_constant, target, 0, 0, emitter_.constant(operand.value)});
    } else if (Emitter::is_temporary(operand.reg) && instructions.back().a == operand.reg &&
               makes_result(instructions.back().op)) {
      instructions.back().a = target;  // the value was made for nothing but this variable
    } else {
      emitter_.emit({Op::move, target, operand.reg, 0, 0});
    }
    return;
  }
  const std::uint8_t value = in_register(operand);
  emitter_.stand_at(variable.begin, variable.end);
  if (variable.kind == Variable::Kind::global) {
    emitter_.emit({Op::store_global, value, 0, 0, variable.number});
  } else if (variable.kind == Variable::Kind::computed) {
    emitter_.emit({Op::write, variable.reg, value, 0, 0});
  } else {
    emitter_.emit({Op::write_fixed, value, 0, 0, variable.number});
  }
}

}  // namespace kerf::gcode
