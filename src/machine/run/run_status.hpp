#pragma once

#include <cstdint>

namespace kerf::machine {

/// How a run stands, or has ended.
enum class RunStatus : std::uint8_t {
  idle,     ///< nothing has run since power-on or reset
  running,  ///< waits for cycle start in the middle of a program: single block, M00, #3006
  stopped,  ///< M01 with the switch on
  end,      ///< M02 or M30
  alarm,
  budget  ///< a limit was reached
};

}  // namespace kerf::machine
