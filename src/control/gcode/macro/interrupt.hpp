#pragma once

#include <cstdint>
#include <utility>

namespace kerf::control {

/// The macro interrupt: the program that answers its signal, between M96 and M97. Value type.
class Interrupt {
 public:
  void signal() { is_pending_ = true; }
  [[nodiscard]] bool is_pending() const { return is_pending_; }
  /// M96 P, M97.
  void allow(std::uint32_t program) { program_ = program; }
  void forbid() { program_ = 0; }
  /// The signal is over; what is to be called for it, 0: nothing is allowed.
  [[nodiscard]] std::uint32_t take() {
    is_pending_ = false;
    return program_;
  }

 private:
  std::uint32_t program_ = 0;
  bool is_pending_ = false;
};

}  // namespace kerf::control
