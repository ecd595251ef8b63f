#include "face/server/hub/internal/part_job.hpp"

#include "machine/definition/tools/tool_comment.hpp"
#include "motion/feed.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

/// As `kerf stock` looks for them: those that somebody describes, the machine's, the comments'.
Outcome<std::vector<stock::Tool>> tools_of(const machine::MachineDefinition& definition,
                                           const base::ProgramText& program) {
  auto source = program.open();
  if (!source) return tl::unexpected(source.error());
  std::vector<stock::Tool> tools = definition.tools;
  const machine::CommentStyle style{
      definition.parameters.power_on_inch ? motion::kMillimetresPerInch : 1, definition.turns()};
  for (stock::Tool& tool : machine::tools_in_comments(**source, style)) tools.push_back(tool);
  return tools;
}

}  // namespace

Outcome<void> check_set_up(const std::string& toml) {
  if (toml.empty()) return {};
  return base::usage("set-ups cannot be read yet: the stock lies around what is cut");
}

Outcome<job::StockJob> part_job(const PartSource& source, const std::string& /*set_up*/,
                                const std::string& /*folder*/) {
  auto text = source.text();
  if (!text) return tl::unexpected(text.error());
  auto tools = tools_of(source.job.definition, *text);
  if (!tools) return tl::unexpected(tools.error());
  job::StockJob job{.job = source.job};
  job.job.program = *text;
  job.shape = machine::StockAround{};
  job.knows_stock = false;
  job.tools = machine::ToolChoice(std::move(*tools));
  return job;
}

}  // namespace kerf::server
