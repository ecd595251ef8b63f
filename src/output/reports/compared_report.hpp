#pragma once

#include <string>

#include "output/reports/stock_facts.hpp"

namespace kerf::output {

/// How the part lies to its design, as the report has it.
[[nodiscard]] std::string compared_json(const StockFacts::Compared& compared, bool turns);
/// A line for people.
[[nodiscard]] std::string compared_text(const StockFacts::Compared& compared);

/// Likewise how it lies to another part.
[[nodiscard]] std::string against_json(const StockFacts::Against& against, bool turns);
[[nodiscard]] std::string against_text(const StockFacts::Against& against);

}  // namespace kerf::output
