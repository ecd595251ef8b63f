#pragma once

#include <bitset>

#include "lang/basic/page.hpp"
#include "lang/basic/scan.hpp"
#include "lang/basic/token_stream.hpp"
#include "lang/vm/emitter.hpp"

namespace kerf::basic {

/// Appends the instructions of a line to a page; the registers behind the variables are free. Knows
/// which variables have certainly been written where the next instruction stands.
class Emitter : public vm::Emitter {
 public:
  using Known = std::bitset<kNear>;

  Emitter(BasicPage& page, const Scan& scan) : vm::Emitter(page, kNear), page_(page), scan_(scan) {}

  [[nodiscard]] BasicPage& page() { return page_; }
  [[nodiscard]] const Scan& scan() const { return scan_; }

  /// A free register. Throws SyntaxError where a statement needs more than there are.
  [[nodiscard]] std::uint8_t allocate() {
    const auto reg = free_register();
    if (!reg) throw SyntaxError{base::Code::basic_syntax, line_text(), line_text(), kTooDeep};
    return *reg;
  }
  static bool is_temporary(std::uint8_t reg) { return reg >= kNear; }
  /// The number of a variable for V[n] of the virtual machine.
  static std::uint32_t slot_of(std::uint32_t variable) {
    return variable < kNear ? variable : vm::kRegisters + variable - kNear;
  }

  [[nodiscard]] Known& known() { return known_; }
  void know(std::uint32_t variable) {
    if (variable < kNear) known_.set(variable);
  }
  [[nodiscard]] bool knows(std::uint32_t variable) const {
    return variable < kNear && known_.test(variable);
  }
  void know_nothing() { known_.reset(); }

 private:
  BasicPage& page_;
  const Scan& scan_;
  Known known_;
};

}  // namespace kerf::basic
