#include "control/gcode/macro/printer.hpp"

#include "control/gcode/macro/print_format.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {

void Printer::print(const gcode::GcodePage& page, const gcode::Statement& statement,
                    const double* registers) {
  line_.clear();
  for (std::uint32_t i = 0; i < statement.count; ++i) {
    const gcode::PrintItem& item = page.print_items[statement.first + i];
    if (item.character != 0) {
      line_ += item.character;
      continue;
    }
    const double value = vm::zero_if_null(registers[item.register_]);
    if (statement.kind == gcode::StatementKind::bprnt) {
      append_binary(line_, value, item.decimals);
    } else {
      append_printed(line_, value, item.integers, item.decimals, !parameters_.print_without_blanks);
    }
  }
  line_ += parameters_.print_cr ? "\r\n" : "\n";
  surroundings_.print(line_);
}

}  // namespace kerf::control
