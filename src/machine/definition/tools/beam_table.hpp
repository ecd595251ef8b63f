#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "base/result.hpp"

namespace kerf::machine {

/// The width of a laser's cut, mm, that the table `[beam]` of a file of tools says (stock.md §1.4);
/// none: it has no such table. Failure (input): an unknown key, or no width, with its line.
[[nodiscard]] base::Outcome<std::optional<double>> read_beam_table(const toml::table& file,
                                                                   const std::string& source);

}  // namespace kerf::machine
