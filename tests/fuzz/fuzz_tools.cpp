// Any bytes as a file of tools: a sentence, or tools that are refused or have a shape, and are read
// again as they were written. The same bytes as a program: its comments make tools with a shape.
#include <toml++/toml.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "machine/definition/tools/tool_comment.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "machine/definition/tools/tool_text.hpp"
#include "stock/tool/insert.hpp"

namespace {

using namespace kerf;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_shape(const stock::Tool& tool) {
  if (tool.is_insert()) {
    require(contour::is_sound(stock::insert_of(tool).outline));
  } else {
    require(!stock::profile_of(tool).is_empty());
  }
}

void check_library(const std::string& text) {
  for (const machine::ToolsUnit unit : {machine::ToolsUnit::mm, machine::ToolsUnit::inch}) {
    const auto library = machine::read_tools(text, "-", unit);
    if (!library) return require(!library.error().message.empty());
    std::vector<stock::Tool> whole;
    for (const stock::Tool& tool : library->tools) {
      if (!stock::objection(tool).empty()) continue;
      check_shape(tool);
      whole.push_back(tool);
    }
    if (whole.empty()) continue;
    const auto again = machine::read_tools(machine::tools_as_toml(whole), "-", unit);
    require(again && again->tools.size() == whole.size());
  }
}

void check_comments(const std::string& text) {
  const auto program = base::SourceFile::from_text("-", text);
  for (const stock::Tool& tool : machine::tools_in_comments(*program, {})) {
    require(stock::objection(tool).empty());
    check_shape(tool);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  check_library(text);
  check_comments(text);
  return 0;
}
