#pragma once

#include <cstdint>
#include <stop_token>

namespace kerf::machine {

/// Limits of a run; 0: none.
struct Budget {
  double seconds = 60;  ///< of computing
  std::uint64_t motions = 50'000'000;
  std::uint64_t steps = 0;     ///< jumps, blocks and pages, about
  bool input_waits = true;     ///< false: a program that waits for an input (InputWait) ends there
  std::stop_token unwanted{};  ///< stopped: the run ends in RunStatus::budget within milliseconds
};

}  // namespace kerf::machine
