#pragma once

#include <cstdint>

#include "control/gcode/acts/auxiliary.hpp"

namespace kerf::control {

/// The macro interrupt: the program that answers its signal, between M96 and M97. Value type.
class Interrupt {
 public:
  void signal() { is_pending_ = true; }
  [[nodiscard]] bool is_pending() const { return is_pending_; }
  /// M96 P and M97 of a block. False: an alarm was raised.
  [[nodiscard]] bool obey(const Auxiliary::Codes& codes, const Words& words, State& state);
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
