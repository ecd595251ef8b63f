#pragma once

#include "base/result.hpp"

namespace kerf::cli {

/// Exit statuses (docs/command-line.md).
enum class ExitStatus : int {
  well = 0,
  findings = 1,  ///< the NC program is wrong, raised an alarm, or a check has findings
  usage = 2,
  files = 3,  ///< an input is missing or unreadable, an output cannot be written
  fault = 4,  ///< a fault of Kerf itself
  budget = 5
};

[[nodiscard]] constexpr ExitStatus status_of(const base::Failure& failure) {
  return failure.kind == base::Failure::Kind::usage ? ExitStatus::usage : ExitStatus::files;
}

}  // namespace kerf::cli
