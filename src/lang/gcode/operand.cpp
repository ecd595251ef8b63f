#include "lang/gcode/operand.hpp"

namespace kerf::gcode {
namespace {

using vm::Op;

// Instructions whose register `a` is nothing but their result.
bool makes_result(Op op) {
  return (op >= Op::load_constant && op <= Op::load_global) || op == Op::read ||
         op == Op::read_fixed || (op >= Op::negate && op <= Op::greater_equal) ||
         op == Op::call_builtin;
}

}  // namespace

std::uint8_t in_register(Emitter& emitter, const Operand& operand) {
  if (!operand.is_constant) return operand.reg;
  const std::uint8_t reg = emitter.allocate();
  emitter.emit({Op::load_constant, reg, 0, 0, emitter.constant(operand.value)});
  return reg;
}

std::uint8_t result_register(Emitter& emitter, const Operand& left, const Operand& right) {
  const bool left_free = !left.is_constant && Emitter::is_temporary(left.reg);
  const bool right_free = !right.is_constant && Emitter::is_temporary(right.reg);
  if (!left_free && !right_free) return emitter.allocate();
  std::uint8_t result = left_free ? left.reg : right.reg;
  if (left_free && right_free && right.reg < result) result = right.reg;
  emitter.release_from(result + 1U);
  return result;
}

Operand load_variable(Emitter& emitter, const Variable& variable) {
  Operand result{.begin = variable.begin, .end = variable.end};
  const bool is_null = variable.kind == Variable::Kind::fixed && variable.number == 0;
  if (variable.kind == Variable::Kind::local || is_null) {
    result.reg = static_cast<std::uint8_t>(variable.number);
    return result;
  }
  emitter.stand_at(variable.begin, variable.end);
  if (variable.kind == Variable::Kind::computed) {
    result.reg = result_register(emitter, {.reg = variable.reg}, {.reg = variable.reg});
    emitter.emit({Op::read, result.reg, variable.reg, 0, 0});
    return result;
  }
  result.reg = emitter.allocate();
  const Op op = variable.kind == Variable::Kind::global ? Op::load_global : Op::read_fixed;
  emitter.emit({op, result.reg, 0, 0, variable.number});
  return result;
}

void store_variable(Emitter& emitter, const Variable& variable, const Operand& operand) {
  auto& instructions = emitter.page().instructions;
  if (variable.kind == Variable::Kind::local) {
    const auto target = static_cast<std::uint8_t>(variable.number);
    if (operand.is_constant) {
      emitter.emit({Op::load_constant, target, 0, 0, emitter.constant(operand.value)});
    } else if (Emitter::is_temporary(operand.reg) && instructions.back().a == operand.reg &&
               makes_result(instructions.back().op)) {
      instructions.back().a = target;  // the value was made for nothing but this variable
    } else {
      emitter.emit({Op::move, target, operand.reg, 0, 0});
    }
    return;
  }
  const std::uint8_t value = in_register(emitter, operand);
  emitter.stand_at(variable.begin, variable.end);
  if (variable.kind == Variable::Kind::global) {
    emitter.emit({Op::store_global, value, 0, 0, variable.number});
  } else if (variable.kind == Variable::Kind::computed) {
    emitter.emit({Op::write, variable.reg, value, 0, 0});
  } else {
    emitter.emit({Op::write_fixed, value, 0, 0, variable.number});
  }
}

}  // namespace kerf::gcode
