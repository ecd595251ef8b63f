#pragma once

#include <string>

#include "base/result.hpp"
#include "face/cli/exit_status.hpp"

namespace kerf::cli {

/// Says on standard error what kept a command from its work: one line, whatever bytes a file name
/// holds. Returns its exit status.
ExitStatus fail(const base::Failure& failure);

/// A failure of wrong usage.
[[nodiscard]] inline tl::unexpected<base::Failure> usage(const std::string& message) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, message});
}

}  // namespace kerf::cli
