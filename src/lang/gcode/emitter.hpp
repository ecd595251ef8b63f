#pragma once

#include <cstdint>

#include "lang/gcode/lexer.hpp"
#include "lang/gcode/page.hpp"
#include "lang/vm/emitter.hpp"

namespace kerf::gcode {

/// Appends the instructions of blocks to a page; the registers behind the local variables are free.
class Emitter : public vm::Emitter {
 public:
  explicit Emitter(GcodePage& page) : vm::Emitter(page, kLocals), page_(page) {}

  [[nodiscard]] GcodePage& page() { return page_; }

  /// A free register. Throws SyntaxError when a block needs more than there are.
  [[nodiscard]] std::uint8_t allocate() {
    const auto reg = free_register();
    if (!reg) {
      throw SyntaxError{base::Code::block_too_long, line_text(), 1,
                        "too many expressions in one block"};
    }
    return *reg;
  }

  static bool is_temporary(std::uint8_t reg) { return reg >= kLocals; }

 private:
  GcodePage& page_;
};

}  // namespace kerf::gcode
