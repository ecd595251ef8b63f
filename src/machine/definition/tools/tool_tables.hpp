#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// A tool and the line that its table begins in.
struct ToolEntry {
  stock::Tool tool;
  std::uint32_t line = 0;
};

/// The `[[tool]]` tables of a file, in its order, with the `[[holder]]` tables that they name
/// (stock.md §1.1). Other tables of the file are nobody's business here. A tool whose type is said
/// has a shape (stock::objection() is empty); one whose type is not said is flat, or `turning`
/// where it has an insert or a nose, and may have none. Failure (input): an unknown key, a value
/// out of range, a shape that cannot be, a number that two tools have: a sentence with its line.
[[nodiscard]] base::Outcome<std::vector<ToolEntry>> read_tool_tables(const toml::table& file,
                                                                     const std::string& source,
                                                                     stock::ToolSource by);

/// Numbers of tools that files may have.
inline constexpr int kLargestToolNumber = 99999999;

}  // namespace kerf::machine
