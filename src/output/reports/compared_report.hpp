#pragma once

#include <string>

#include "output/reports/stock_facts.hpp"

namespace kerf::output {

/// How the part lies to its design, as the report has it.
[[nodiscard]] std::string compared_json(const StockFacts::Compared& compared, bool turns);
/// A line for people.
[[nodiscard]] std::string compared_text(const StockFacts::Compared& compared);

}  // namespace kerf::output
