#pragma once

#include <string>
#include <vector>

#include "output/reports/stock_facts.hpp"
#include "output/solid/solid_file.hpp"
#include "stock/cutting/tool_span.hpp"

namespace kerf::output {

/// The pieces of a part for a file: materials are the uncut stock and the tools, in the colours of
/// the pictures.
[[nodiscard]] SolidFile solid_file(const std::string& name, const StockFacts& facts,
                                   const std::vector<stock::ToolSpan>& tools,
                                   const stock::surface::Surface& part);

}  // namespace kerf::output
