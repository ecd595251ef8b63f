#include "face/cli/stock_order.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/decimal.hpp"
#include "base/output_file.hpp"
#include "face/cli/operator_input.hpp"
#include "face/cli/stock_words.hpp"
#include "job/facts_of_stock.hpp"
#include "machine/definition/tools/tool_comment.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "motion/feed.hpp"
#include "output/reports/stock_report.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

job::StockModel model_named(const std::string& name) {
  if (name == "zmap") return job::StockModel::zmap;
  if (name == "profile") return job::StockModel::profile;
  if (name == "sheet") return job::StockModel::sheet;
  return name == "tridexel" ? job::StockModel::tridexel : job::StockModel::automatic;
}

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

/// The width of a laser's cut, where somebody but the machine says it.
Outcome<std::optional<double>> kerf_of(const TableOptions& options) {
  if (options.kerf.empty()) return std::optional<double>{};
  const double kerf = base::read_number(options.kerf).value_or(0);
  if (!(kerf > 0)) return base::usage("--kerf " + options.kerf + ": a cut has a width");
  return std::optional(kerf);
}

}  // namespace

Outcome<bool> has_table(const TableOptions& options) {
  if (!options.stock.empty() || !options.fixtures.empty()) return true;
  if (options == TableOptions{}) return false;
  return base::usage(
      "what lies on the table is not said: --stock, beside the options that speak of it");
}

std::string shape_word(const TableOptions& options) {
  return options.stock.empty() ? "extents" : options.stock;
}

Outcome<base::ProgramText> kept_program(const std::string& path) {
  if (path != "-") return base::ProgramText::at_path(path);
  constexpr std::size_t kLargest = 1UL << 30;
  auto text = base::read_whole(path, kLargest, "a program");
  if (!text) return tl::unexpected(text.error());
  return base::ProgramText::of(path, std::move(*text));
}

Outcome<job::StockJob> stock_job(const RunOptions& run, OrderedJob ordered,
                                 base::ProgramText program, const base::SourceFile& source) {
  const TableOptions& options = run.table;
  job::StockJob job{.job = std::move(ordered.job)};
  job.job.program = std::move(program);
  auto shape = machine::stock_word(shape_word(options), "--stock");
  if (!shape) return tl::unexpected(shape.error());
  job.shape = std::move(*shape);
  job.knows_stock = !options.stock.empty();
  auto zero = machine::stock_zero(options.zero);
  if (!zero) return tl::unexpected(zero.error());
  job.zero = *zero;
  for (const std::string& words : options.fixtures) {
    auto fixture = machine::stock_word(words, "--fixture");
    if (!fixture) return tl::unexpected(fixture.error());
    const auto* const piece = std::get_if<stock::Workpiece>(&*fixture);
    if (piece == nullptr)
      return base::usage("--fixture " + words + ": a box, a cylinder or a tube is expected");
    job.fixtures.push_back({words, *piece});
  }
  job.model = model_named(options.model);
  if (!options.cell.empty()) {
    job.cell_mm = base::read_number(options.cell).value_or(0);
    if (!(*job.cell_mm > 0)) return base::usage("--cell " + options.cell + ": a cell has a size");
  }
  if (auto kerf = kerf_of(options); !kerf) {
    return tl::unexpected(kerf.error());
  } else {
    job.kerf_mm = *kerf;
  }
  if (!options.memory.empty())
    job.memory_bytes = static_cast<std::size_t>(base::read_number(options.memory).value_or(0))
                       << 20;
  job.jobs = options.jobs;
  auto material = material_of(options.material);
  if (!material) return tl::unexpected(material.error());
  job.material = *material;
  auto left_out = left_out_of(options.no_checks);
  if (!left_out) return tl::unexpected(left_out.error());
  job.left_out = std::move(*left_out);
  job.has_real_lengths = options.lengths == "real";
  auto library = tools_of(run);
  if (!library) return tl::unexpected(library.error());
  job.remarks = std::move(library->remarks);
  std::vector<stock::Tool> tools = std::move(library->tools);
  const machine::MachineDefinition& definition = job.job.definition;
  if (definition.axes.beam && !job.kerf_mm) job.kerf_mm = library->kerf_mm;
  tools.insert(tools.end(), definition.tools.begin(), definition.tools.end());
  const machine::CommentStyle style{
      definition.parameters.power_on_inch ? motion::kMillimetresPerInch : 1, definition.turns()};
  for (stock::Tool& tool : machine::tools_in_comments(source, style)) tools.push_back(tool);
  job.tools = machine::ToolChoice(std::move(tools));
  return job;
}

bool counts(const TableOptions& options, const output::StockFacts::Told& told) {
  if (options.fail_on == "never") return false;
  return options.fail_on != "error" || told.diagnostic.severity == base::Severity::error;
}

bool fails(const TableOptions& options, const output::StockFacts& facts) {
  return std::any_of(facts.findings.begin(), facts.findings.end(),
                     [&](const auto& told) { return counts(options, told); });
}

base::Outcome<TableRun> run_on_table(const RunOptions& options) {
  auto program = kept_program(options.program);
  if (!program) return tl::unexpected(program.error());
  auto source = program->open();
  if (!source) return tl::unexpected(source.error());
  auto ordered = job_of(options, **source);
  if (!ordered) return tl::unexpected(ordered.error());
  TableRun made{.cut = {}, .facts = {}, .ready = {nullptr, ordered->choice, ordered->hint}};
  auto job = stock_job(options, std::move(*ordered), std::move(*program), **source);
  if (!job) return tl::unexpected(job.error());
  job->job.input = kept_operator_input();
  auto cut = job::cut_stock(*job);
  if (!cut) return tl::unexpected(cut.error());
  made.cut = std::move(*cut);
  made.facts = job::facts_of(made.cut);
  made.facts.shape = shape_word(options.table);
  made.facts.run.chosen = made.ready.choice.chosen;
  job->job.skips = made.cut.skips;
  auto again = job::Run::of(job->job);
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
