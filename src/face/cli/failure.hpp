#pragma once

#include <string>

#include "base/result.hpp"
#include "face/cli/exit_status.hpp"

namespace kerf::cli {

/// Says on standard error what kept a command from its work: one line, whatever bytes a file name
/// holds. Returns its exit status.
ExitStatus fail(const base::Failure& failure);

using base::usage;

}  // namespace kerf::cli
