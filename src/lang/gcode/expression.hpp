#pragma once

#include <cstdint>

#include "lang/gcode/builtins.hpp"
#include "lang/gcode/emitter.hpp"
#include "lang/gcode/keywords.hpp"
#include "lang/gcode/lexer.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/named_variable.hpp"
#include "lang/gcode/operand.hpp"

namespace kerf::gcode {

/// The longest literal of a macro statement (VAR-4).
inline constexpr int kLiteralDigits = 12;

/// Reads expressions and emits their code (docs/dialect.md §4). Every function throws SyntaxError.
///
/// Precedence, from what binds tightest: brackets, functions and signs, * / AND MOD, + - OR XOR,
/// comparisons; left to right within a level. AND, OR, XOR work on bits between numbers and as
/// logic between comparisons.
class Expression {
 public:
  Expression(Cursor& cursor, Emitter& emitter, NameTable& names)
      : cursor_(cursor), emitter_(emitter), names_(names) {}

  /// ROUND rounds to the least increment of this address instead of to an integer (EXP-12); 0: not.
  void set_address(char letter) { address_ = letter; }

  /// A numeric expression up to where it ends.
  [[nodiscard]] Operand number();
  /// "[ expression ]", standing on the bracket.
  [[nodiscard]] Operand bracketed_number();
  /// "[ condition ]" of IF or WHILE, standing on the bracket, which does not count as a nesting
  /// level. Anything but a comparison is `format` (PS1137 or PS1138).
  [[nodiscard]] Operand bracketed_condition(base::Code format);
  /// "#…", standing on the '#'.
  [[nodiscard]] Variable variable();
  /// "[#NAME]", standing on the bracket.
  [[nodiscard]] Variable named_variable() { return NamedVariable(cursor_, names_).read(); }
  [[nodiscard]] bool at_named_variable() const { return NamedVariable(cursor_, names_).is_next(); }

  [[nodiscard]] Operand load(const Variable& variable) { return load_variable(emitter_, variable); }
  [[nodiscard]] std::uint8_t in_register(const Operand& operand) {
    return gcode::in_register(emitter_, operand);
  }
  /// Emits `variable = operand`.
  void store(const Variable& variable, const Operand& operand) {
    store_variable(emitter_, variable, operand);
  }
  /// Emits a branch, to be landed by the caller, taken when the truth of `condition` is `when`.
  [[nodiscard]] std::uint32_t branch(const Operand& condition, bool when);
  /// Emits a call of a function with one or two arguments.
  [[nodiscard]] Operand call(Function function, const Operand& argument, const char* begin);
  [[nodiscard]] Operand call(Function function, const Operand& first, const Operand& second);

 private:
  Operand comparison();
  Operand sum();
  Operand term();
  /// Operands with one of `signs` or of the words that `joins` knows between them.
  using Rule = Operand (Expression::*)();
  Operand chain(Rule operand, std::string_view signs, bool (*joins)(Keyword));
  Operand signed_operand();
  Operand primary();
  Operand literal();
  Operand bracketed();
  Operand negated(const Operand& operand, const char* begin);
  Operand function(Keyword keyword, const char* begin);
  Operand rounded(const char* begin);
  Operand arc_tangent(const char* begin);
  Operand power();
  Operand parameter(const char* begin);
  Operand logic(Keyword keyword, const Operand& left, const Operand& right);
  Operand arithmetic(char sign, const Operand& left, const Operand& right);
  void require_number(const Operand& operand) const;
  void open_bracket();
  void close_bracket();
  [[nodiscard]] KeywordMatch next_operator() const;
  [[nodiscard]] Operand temporary(std::uint8_t reg, const char* begin, bool truth = false) const;
  void stand_at(const char* begin) { emitter_.stand_at(begin, cursor_.behind()); }
  [[noreturn]] void fail(base::Code code, std::string_view detail = {},
                         std::string_view hint = {}) const;
  [[noreturn]] void fail_since(base::Code code, const char* begin,
                               std::string_view detail = {}) const;

  Cursor& cursor_;
  Emitter& emitter_;
  NameTable& names_;
  int depth_ = 0;
  char address_ = 0;
};

}  // namespace kerf::gcode
