#pragma once

#include <cstdint>

#include "lang/basic/builtins.hpp"
#include "lang/basic/emitter.hpp"

namespace kerf::basic {

/// Where the value of an expression is when the program runs.
struct Operand {
  bool is_constant = false;
  double value = 0;      ///< of a constant
  std::uint8_t reg = 0;  ///< otherwise
};

/// Compiles expressions by recursive descent; the rule of the grammar stands above each function.
/// Throws SyntaxError: LB0001, LB0002, LB0003, LB0017.
class Expression {
 public:
  Expression(TokenStream& tokens, Emitter& emitter) : tokens_(tokens), emitter_(emitter) {}

  /// An expression; at its end whatever comes.
  Operand parse();
  /// An expression into a register that is handed out next: consecutive calls make consecutive
  /// registers.
  std::uint8_t parse_into_next();
  /// A branch that is taken where the expression is `when` (true: not 0). Returns it, to be landed.
  std::uint32_t branch(const Operand& condition, bool when);
  void store(std::uint32_t variable, const Operand& value);
  /// The number of a variable that the line names.
  [[nodiscard]] std::uint32_t number_of(const Token& name) const;

 private:
  class Level;

  Operand disjunction();
  Operand conjunction();
  Operand negation();
  Operand comparison();
  Operand sum();
  Operand term();
  Operand unary();
  Operand power();
  Operand atom();
  Operand bracketed();
  Operand function();
  Operand arguments_of(Word word, const Token& name);
  Operand distance(std::uint8_t first, std::size_t count, const Token& name);
  Operand variable(const Token& name);

  Operand binary(vm::Op op, const Operand& left, const Operand& right, const Token& sign);
  Operand call(Function function, const Operand& left, const Operand& right, const Token& sign);
  Operand inquire(Inquiry inquiry, const Token& name);
  std::uint8_t in_register(const Operand& operand);
  std::uint8_t result_register(std::uint32_t free_from);
  void move_to(std::uint8_t reg, const Operand& operand);

  TokenStream& tokens_;
  Emitter& emitter_;
  int depth_ = 0;  // of Levels
};

}  // namespace kerf::basic
