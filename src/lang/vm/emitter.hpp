#pragma once

#include <cstdint>
#include <optional>

#include "lang/vm/code_page.hpp"

namespace kerf::vm {

/// Appends instructions to a page, each with the text that it was made from, and hands out
/// registers: those from `first_free` on are for what a statement works out.
class Emitter {
 public:
  Emitter(CodePage& page, std::uint32_t first_free)
      : page_(page), first_free_(first_free), next_register_(first_free) {}

  /// Begins a block, with all registers free; `line_text` is the first byte of its line.
  void begin_block(const char* line_text) {
    line_text_ = line_text;
    next_register_ = first_free_;
  }

  /// The text that the instructions emitted from now on belong to.
  void stand_at(const char* begin, const char* end) {
    span_ = Span::between(begin, end, line_text_);
  }

  std::uint32_t emit(const Instruction& instruction) {
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

  /// A free register; nothing when there is none.
  [[nodiscard]] std::optional<std::uint8_t> free_register() {
    if (next_register_ >= kRegisters) return std::nullopt;
    return static_cast<std::uint8_t>(next_register_++);
  }
  /// Frees every register from `first` on that was handed out.
  void release_from(std::uint32_t first) {
    if (first < next_register_ && first >= first_free_) next_register_ = first;
  }
  [[nodiscard]] std::uint32_t mark() const { return next_register_; }

  [[nodiscard]] const char* line_text() const { return line_text_; }

 private:
  CodePage& page_;
  std::uint32_t first_free_;
  std::uint32_t next_register_;
  const char* line_text_ = nullptr;
  Span span_;
};

}  // namespace kerf::vm
