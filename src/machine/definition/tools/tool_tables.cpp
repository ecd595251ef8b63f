#include "machine/definition/tools/tool_tables.hpp"

#include <set>

#include "machine/definition/tools/internal/tool_reader.hpp"

namespace kerf::machine {
namespace {

std::vector<ToolEntry> read_entries(const toml::table& file, stock::ToolSource by) {
  const HolderNames holders = read_holders(file);
  std::vector<ToolEntry> entries;
  const toml::node* const node = file.get("tool");
  if (node == nullptr || !node->is_array_of_tables()) return entries;
  std::set<int> numbers;
  for (const toml::node& each : *node->as_array()) {
    stock::Tool tool = read_tool(*each.as_table(), holders);
    if (!numbers.insert(tool.number).second)
      throw WrongTool{each, "tool " + std::to_string(tool.number) + " is there twice"};
    tool.source = by;
    entries.push_back({std::move(tool), each.source().begin.line});
  }
  return entries;
}

}  // namespace

base::Outcome<std::vector<ToolEntry>> read_tool_tables(const toml::table& file,
                                                       const std::string& source,
                                                       stock::ToolSource by) {
  try {
    return read_entries(file, by);
  } catch (const WrongTool& wrong) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::input, source + ":" + std::to_string(wrong.line) + ": " + wrong.what});
  }
}

}  // namespace kerf::machine
