#pragma once

#include <string>

#include "face/cli/check_report.hpp"
#include "face/cli/commands.hpp"

namespace kerf::cli {

/// What is wrong with a pattern: bytes or lines that are no record, timers that overflow, and
/// joints beyond their travel. It runs on the machine of the options, or on the one of `kerf
/// pattern replay`.
[[nodiscard]] FileReport check_pattern(const std::string& path, const CheckOptions& options);

}  // namespace kerf::cli
