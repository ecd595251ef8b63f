#include "machine/definition/tools/tool_import.hpp"

#include <toml++/toml.h>

#include "base/source_file.hpp"
#include "machine/definition/tools/internal/letters.hpp"
#include "machine/definition/tools/internal/library_builder.hpp"
#include "machine/definition/tools/internal/zip_archive.hpp"
#include "machine/definition/tools/tool_tables.hpp"

namespace kerf::machine {
namespace {

/// The first line that is neither empty nor a comment of LinuxCNC.
std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && line[first] != ';') return line.substr(first);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// T and a number, and a pocket or a size behind it: a tool change of a program has none.
bool is_table_line(std::string_view line) {
  if (line.size() < 2 || folded(line[0]) != 'T' || !is_digit(line[1])) return false;
  const std::size_t blank = line.find_first_of(" \t\r");
  if (blank == std::string_view::npos) return true;
  const std::size_t next = line.find_first_not_of(" \t\r", blank);
  return next == std::string_view::npos ||
         std::string_view("PDXYZABCUVWIJQ;").find(folded(line[next])) != std::string_view::npos;
}

bool is_toml(std::string_view text) {
  return text.find("[[tool]]") != std::string_view::npos ||
         text.find("[[holder]]") != std::string_view::npos;
}

base::Outcome<ToolLibrary> read_toml(const std::string& text, const std::string& path) {
  try {
    auto entries = read_tool_tables(toml::parse(text), path, stock::ToolSource::file);
    if (!entries) return tl::unexpected(entries.error());
    ToolLibrary library;
    for (ToolEntry& entry : *entries) library.tools.push_back(std::move(entry.tool));
    return library;
  } catch (const toml::parse_error& error) {
    return unreadable(path + ":" + std::to_string(error.source().begin.line),
                      std::string(error.description()));
  }
}

}  // namespace

ToolFormat tool_format_of(std::string_view text) {
  if (is_zip(text)) return ToolFormat::fusion;
  const std::string_view line = first_line(text);
  if (line.starts_with('{')) {
    return text.find("\"data\"") != std::string_view::npos    ? ToolFormat::fusion
           : text.find("\"tools\"") != std::string_view::npos ? ToolFormat::freecad
                                                              : ToolFormat::other;
  }
  if (is_table_line(line)) return ToolFormat::linuxcnc;
  return is_toml(text) ? ToolFormat::toml : ToolFormat::other;
}

base::Outcome<ToolLibrary> read_tools(const std::string& text, const std::string& path,
                                      ToolsUnit unit) {
  if (text.size() > kLargestToolFile) return unreadable(path, "a file of tools is not so large");
  switch (tool_format_of(text)) {
    case ToolFormat::toml: return read_toml(text, path);
    case ToolFormat::linuxcnc: return read_linuxcnc(text, unit);
    case ToolFormat::fusion: return read_fusion(text, path);
    case ToolFormat::freecad: return read_freecad(text, path);
    case ToolFormat::other: break;
  }
  return unreadable(path,
                    "these are no tools: [[tool]] tables of TOML, a tool.tbl of LinuxCNC, a "
                    "library of Fusion or of FreeCAD are");
}

base::Outcome<ToolLibrary> read_tool_file(const std::string& path, ToolsUnit unit) {
  const auto text = base::read_whole(path, kLargestToolFile, "a file of tools");
  if (!text) return tl::unexpected(text.error());
  return read_tools(*text, path, unit);
}

}  // namespace kerf::machine
