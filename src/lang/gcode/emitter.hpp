#pragma once

#include <cstdint>

#include "lang/gcode/lexer.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::gcode {

/// Appends instructions to a page, each with the text that it was made from, and hands out
/// registers.
class Emitter {
 public:
  explicit Emitter(GcodePage& page) : page_(page) {}

  [[nodiscard]] GcodePage& page() { return page_; }

  /// Begins a block; `line_text` is the first byte of its line.
  void begin_block(const char* line_text) {
    line_text_ = line_text;
    next_register_ = kLocals;
  }

  /// The text that the instructions emitted from now on belong to.
  void stand_at(const char* begin, const char* end) {
    span_ = vm::Span::between(begin, end, line_text_);
  }

  std::uint32_t emit(vm::Instruction instruction) {
    page_.instructions.push_back(instruction);
    page_.spans.push_back(span_);
    return static_cast<std::uint32_t>(page_.instructions.size() - 1);
  }
  [[nodiscard]] std::uint32_t here() const {
    return static_cast<std::uint32_t>(page_.instructions.size());
  }
  /// Makes the jump or branch `instruction` go to the next instruction to be emitted.
  void land(std::uint32_t instruction) { page_.instructions[instruction].n = here(); }

  [[nodiscard]] std::uint32_t constant(double value) {
    page_.constants.push_back(value);
    return static_cast<std::uint32_t>(page_.constants.size() - 1);
  }

  /// A free register. Throws SyntaxError when a block needs more than there are.
  [[nodiscard]] std::uint8_t allocate() {
    if (next_register_ >= vm::kRegisters) {
      throw SyntaxError{base::Code::block_too_long, line_text_, 1,
                        "too many expressions in one block"};
    }
    return static_cast<std::uint8_t>(next_register_++);
  }
  /// Frees every register from `first` on that allocate() has given out.
  void release_from(std::uint32_t first) {
    if (first < next_register_ && first >= kLocals) next_register_ = first;
  }
  [[nodiscard]] std::uint32_t mark() const { return next_register_; }

  static bool is_temporary(std::uint8_t reg) { return reg >= kLocals; }

 private:
  GcodePage& page_;
  const char* line_text_ = nullptr;
  std::uint32_t next_register_ = kLocals;
  vm::Span span_;
};

}  // namespace kerf::gcode
