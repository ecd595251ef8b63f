#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// What a file of tools is, by its content (stock.md §1.6).
enum class ToolFormat : std::uint8_t {
  toml,      ///< [[tool]] tables: read_tool_tables()
  linuxcnc,  ///< lines of T, P, D, Z …: tool.tbl
  fusion,    ///< a library in JSON, or a ZIP that holds one
  freecad,   ///< a library (.fctl) that names tool bits (.fctb)
  other,     ///< none of these
};
[[nodiscard]] ToolFormat tool_format_of(std::string_view text);

/// Unit of a table that does not say its own.
enum class ToolsUnit : std::uint8_t { mm, inch };

/// TOOL_IMPORT: what has not been understood of a tool, a sentence without a full stop.
struct ImportRemark {
  int number = 0;  ///< of the tool; 0: it has none
  std::string text;
};

/// The tools of a file, each with a shape (stock::objection() is empty) or at least a length, and
/// what is missing.
struct ToolLibrary {
  std::vector<stock::Tool> tools;
  std::vector<ImportRemark> remarks;
  std::optional<double> kerf_mm{};  ///< of a laser's beam, where TOML has a table of it
};

/// Reads a file of tools in any of the formats. `path` is where it is from: FreeCAD's tool bits are
/// looked for beside it and in ../Bit. Failure (input): it is damaged, too large or of no format
/// that is known. What is wrong with one tool of another program's library is a remark; in TOML it
/// is a failure.
[[nodiscard]] base::Outcome<ToolLibrary> read_tools(const std::string& text,
                                                    const std::string& path, ToolsUnit unit);
/// Likewise, from the file.
[[nodiscard]] base::Outcome<ToolLibrary> read_tool_file(const std::string& path, ToolsUnit unit);

/// Files of tools, and what they unpack to.
inline constexpr std::size_t kLargestToolFile = std::size_t{1} << 24U;

}  // namespace kerf::machine
