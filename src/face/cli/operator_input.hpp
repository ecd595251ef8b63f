#pragma once

#include <optional>
#include <string>

namespace kerf::cli {

/// The next line of standard input, for INPUT; nothing when it is closed. On a terminal a line that
/// is no number is asked for again. Everything printed so far is put out first.
[[nodiscard]] std::optional<std::string> operator_input();

}  // namespace kerf::cli
