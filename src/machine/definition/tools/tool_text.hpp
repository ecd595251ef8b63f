#pragma once

#include <string>
#include <vector>

#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// A tool as a `[[tool]]` table. read_tool_tables() reads the same tool from it, but for the
/// source.
void append_tool(std::string& out, const stock::Tool& tool);

/// Tools as a file for `--tools`, an empty line between two.
[[nodiscard]] std::string tools_as_toml(const std::vector<stock::Tool>& tools);

}  // namespace kerf::machine
