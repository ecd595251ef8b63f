#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lang/gcode/emitter.hpp"
#include "lang/gcode/expression.hpp"
#include "lang/gcode/keywords.hpp"
#include "lang/gcode/lexer.hpp"
#include "lang/gcode/name_table.hpp"

namespace kerf::gcode {

/// Compiles the macro statements of blocks: assignments, jumps, loops, output (docs/dialect.md §5,
/// §7). Every function throws SyntaxError.
class StatementParser {
 public:
  /// All must outlive the parser.
  StatementParser(GcodePage& page, Emitter& emitter, NameTable& names)
      : page_(page), emitter_(emitter), names_(names) {}

  /// The rest of a statement whose keyword has been read, up to the end of its block.
  void statement(Cursor& cursor, const KeywordMatch& match);
  void assignment(Cursor& cursor);

 private:
  void if_statement(Cursor& cursor);
  void go_to(Cursor& cursor);
  void while_statement(Cursor& cursor);
  void do_statement(Cursor& cursor, std::uint32_t head, bool conditional, const Operand& condition);
  void end_statement(Cursor& cursor);
  std::uint8_t loop_number(Cursor& cursor);
  void print(Cursor& cursor, StatementKind kind);
  void print_variable(Cursor& cursor);
  void name_variables(Cursor& cursor);
  std::string variable_name(Cursor& cursor);
  void host_statement(StatementKind kind, std::uint32_t first, std::uint32_t count);
  void expect_end(Cursor& cursor, std::string_view hint = "put it into a block of its own");

  GcodePage& page_;
  Emitter& emitter_;
  NameTable& names_;
};

}  // namespace kerf::gcode
