#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace kerf::cli {

/// The next line of standard input, for INPUT; nothing when it is closed. On a terminal a line that
/// is no number is asked for again. Everything printed so far is put out first.
[[nodiscard]] std::optional<std::string> operator_input();

/// The same for a program that runs more than once: what was entered is kept, and is asked for by
/// the number of the line from 0.
[[nodiscard]] std::function<std::optional<std::string>(std::size_t)> kept_operator_input();

}  // namespace kerf::cli
