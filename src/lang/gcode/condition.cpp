#include "lang/gcode/condition.hpp"

#include "lang/gcode/builtins.hpp"
#include "lang/gcode/expression.hpp"

namespace kerf::gcode {

base::Result<std::unique_ptr<GcodePage>> compile_condition(const std::string& text,
                                                           NameTable& names) {
  auto page = std::make_unique<GcodePage>();
  page->builtins = builtin_table();
  const std::string bracketed = "[" + text + "]";
  Emitter emitter(*page);
  emitter.begin_block(bracketed.data());
  Cursor cursor(bracketed);
  try {
    Expression expression(cursor, emitter, names);
    const Operand truth = expression.bracketed_condition(base::Code::if_format);
    if (!cursor.done())
      throw SyntaxError{base::Code::if_format, cursor.at(), 1, "nothing follows a comparison"};
    const std::uint32_t reg = expression.in_register(truth);
    emitter.emit({vm::Op::do_block, 0, 0, 0, reg});
  } catch (const SyntaxError& error) {
    const base::Place place{.line = 1,
                            .column = static_cast<std::uint32_t>(error.at - bracketed.data()),
                            .length = static_cast<std::uint32_t>(error.length)};
    return tl::unexpected(
        base::make_error(error.code, place, std::string(error.detail), std::string(error.hint)));
  }
  return page;
}

}  // namespace kerf::gcode
