#pragma once

#include <string>

#include "output/drawings/draw_facts.hpp"

namespace kerf::output {

/// The report of `kerf draw` as JSON (docs/drawings.md).
[[nodiscard]] std::string draw_report(const DrawFacts& facts);

}  // namespace kerf::output
