#pragma once

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// T of a lathe: turns the turret and chooses the offset of the tool (docs/dialect/turning.md, T).
/// The last digits of T are the offset's number, those before them the tool's.
class Turret {
 public:
  explicit Turret(State& state) : state_(state) {}

  /// Takes a T over; emits nothing. False: an alarm was raised (PS0030).
  [[nodiscard]] bool read(const gcode::Word& word);
  /// Turns to the tool that was read, unless it is there.
  void turn();

 private:
  void choose_offset();

  State& state_;
  std::int64_t wanted_ = 0;  // tool
};

}  // namespace kerf::control
