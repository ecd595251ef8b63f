#pragma once

#include <bitset>
#include <optional>
#include <utility>

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

  /// `early`: what the first page has found out; nothing while that one is compiled.
  Emitter(BasicPage& page, const Scan& scan, std::optional<Known> early)
      : vm::Emitter(page, kNear),
        page_(page),
        scan_(scan),
        known_(early.value_or(Known())),
        early_(known_),
        parted_(early.has_value()) {}

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
  /// The way to the next instruction is open: from here on only that is known which was written
  /// before any way parted.
  void know_little() {
    part_ways();
    known_ = early_;
  }
  /// Ways part or meet here for the first time, unless they have before.
  void part_ways() {
    if (!std::exchange(parted_, true)) early_ = known_;
  }
  /// What every statement behind this page may rely on. Precondition: the page is the first.
  [[nodiscard]] Known early() const { return parted_ ? early_ : known_; }

 private:
  BasicPage& page_;
  const Scan& scan_;
  Known known_;
  Known early_;
  bool parted_;
};

}  // namespace kerf::basic
