#include "face/cli/stock_order.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/output_file.hpp"
#include "face/cli/operator_input.hpp"
#include "face/cli/stock_table.hpp"
#include "job/facts_of_stock.hpp"
#include "job/part_comparison.hpp"
#include "job/stock_table.hpp"
#include "machine/definition/tools/tool_comment.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "motion/feed.hpp"
#include "output/reports/stock_report.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

/// The tools of a file, none where it is the control's own punch-out.
Outcome<machine::ToolLibrary> tools_of(const RunOptions& options) {
  if (options.tools.empty()) return {};
  auto text = base::read_whole(options.tools, machine::kLargestToolFile, "a file of tools");
  if (!text) return tl::unexpected(text.error());
  if (machine::tool_format_of(*text) == machine::ToolFormat::other) return {};
  return machine::read_tools(
      *text, options.tools,
      options.tools_unit == "inch" ? machine::ToolsUnit::inch : machine::ToolsUnit::mm);
}

/// Who describes tools, those that count more first.
Outcome<void> take_tools(const RunOptions& run, const machine::SetUp& set_up,
                         const base::SourceFile& source, job::StockJob& job) {
  auto library = tools_of(run);
  if (!library) return tl::unexpected(library.error());
  job.remarks = std::move(library->remarks);
  std::vector<stock::Tool> tools = std::move(library->tools);
  tools.insert(tools.end(), set_up.tools.begin(), set_up.tools.end());
  const machine::MachineDefinition& definition = job.job.definition;
  if (definition.axes.beam && !job.kerf_mm) job.kerf_mm = library->kerf_mm;
  tools.insert(tools.end(), definition.tools.begin(), definition.tools.end());
  const machine::CommentStyle style{
      definition.parameters.power_on_inch ? motion::kMillimetresPerInch : 1, definition.turns()};
  for (stock::Tool& tool : machine::tools_in_comments(source, style)) tools.push_back(tool);
  job.tools = machine::ToolChoice(std::move(tools));
  return {};
}

}  // namespace

Outcome<base::ProgramText> kept_program(const std::string& path) {
  if (path != "-") return base::ProgramText::at_path(path);
  constexpr std::size_t kLargest = 1UL << 30;
  auto text = base::read_whole(path, kLargest, "a program");
  if (!text) return tl::unexpected(text.error());
  return base::ProgramText::of(path, std::move(*text));
}

Outcome<job::StockJob> stock_job(const RunOptions& run, const machine::SetUp& set_up,
                                 OrderedJob ordered, base::ProgramText program,
                                 const base::SourceFile& source) {
  job::StockJob job{.job = std::move(ordered.job)};
  job.job.program = std::move(program);
  if (auto taken = take_means(run.table, job); !taken) return tl::unexpected(taken.error());
  if (auto laid = job::lay(set_up, source, job); !laid) return tl::unexpected(laid.error());
  if (auto taken = take_tools(run, set_up, source, job); !taken)
    return tl::unexpected(taken.error());
  return job;
}

bool counts(const machine::SetUp& set_up, const output::StockFacts::Told& told) {
  const machine::FailOn from = set_up.fail_on.value_or(machine::FailOn::warning);
  if (from == machine::FailOn::never) return false;
  return from != machine::FailOn::error || told.diagnostic.severity == base::Severity::error;
}

bool fails(const machine::SetUp& set_up, const output::StockFacts& facts) {
  return std::any_of(facts.findings.begin(), facts.findings.end(),
                     [&](const auto& told) { return counts(set_up, told); });
}

Outcome<TableOrder> order_on_table(const RunOptions& options, machine::SetUp set_up) {
  auto program = kept_program(options.program);
  if (!program) return tl::unexpected(program.error());
  auto source = program->open();
  if (!source) return tl::unexpected(source.error());
  auto ordered = job_of(options, **source);
  if (!ordered) return tl::unexpected(ordered.error());
  ReadyRun ready{nullptr, ordered->choice, ordered->hint};
  auto job = stock_job(options, set_up, std::move(*ordered), std::move(*program), **source);
  if (!job) return tl::unexpected(job.error());
  return TableOrder{std::move(set_up), std::move(ready), std::move(*job)};
}

Outcome<TableRun> run_on_table(const RunOptions& options) {
  auto set_up = set_up_of(options.table);
  if (!set_up) return tl::unexpected(set_up.error());
  const auto design = std::exchange(set_up->design, std::nullopt);
  auto order = order_on_table(options, std::move(*set_up));
  if (!order) return tl::unexpected(order.error());
  TableRun made{
      .set_up = std::move(order->set_up), .cut = {}, .facts = {}, .ready = std::move(order->ready)};
  job::StockJob& job = order->job;
  job.job.input = kept_operator_input();
  if (auto taken = job::take_design(design, job); !taken) return tl::unexpected(taken.error());
  auto cut = job::cut_stock(job);
  if (!cut) return tl::unexpected(cut.error());
  if (auto compared = job::compare_with_design(job, *cut); !compared)
    return tl::unexpected(compared.error());
  made.cut = std::move(*cut);
  made.facts = job::facts_of(made.cut);
  made.facts.shape = job.said;
  made.facts.run.chosen = made.ready.choice.chosen;
  job.job.skips = made.cut.skips;
  auto again = job::Run::of(job.job);
  if (!again) return tl::unexpected(again.error());
  made.ready.run = std::move(*again);
  return made;
}

void report_stock(const RunOptions& options, const output::StockFacts& facts,
                  const base::SourceSet& sources) {
  if (options.diagnostics != DiagnosticFormat::json) {
    const std::string text = output::stock_report_text(facts, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return;
  }
  for (const output::StockFacts::Told& told : facts.findings) {
    const std::string text = output::diagnostic_json(told.diagnostic, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace kerf::cli
