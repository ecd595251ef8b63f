#pragma once

#include <string>

#include "output/drawings/draw_facts.hpp"

namespace kerf::output {

/// What was read and planned, for people: indented lines.
[[nodiscard]] std::string draw_summary(const DrawFacts& facts);

}  // namespace kerf::output
