#include <fmt/format.h>

#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "machine/definition/tools/tool_text.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {

ExitStatus tools(const ToolsOptions& options) {
  const auto unit = options.unit == "inch" ? machine::ToolsUnit::inch : machine::ToolsUnit::mm;
  const auto library = machine::read_tool_file(options.file, unit);
  if (!library) return fail(library.error());
  for (const machine::ImportRemark& remark : library->remarks) {
    const std::string whose = remark.number > 0 ? fmt::format("T{}: ", remark.number) : "";
    fmt::print(stderr, "kerf: {}\n", output::printable(options.file + ": " + whose + remark.text));
  }
  fmt::print("{}", machine::tools_as_toml(library->tools));
  return ExitStatus::well;
}

}  // namespace kerf::cli
