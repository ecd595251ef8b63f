#pragma once

#include <string_view>

namespace kerf::training {

/// Lines of a program that hold more than blanks, comments and the percent signs of a tape.
/// Precondition: Kerf runs the dialect.
[[nodiscard]] int code_lines(std::string_view program, std::string_view dialect);

}  // namespace kerf::training
