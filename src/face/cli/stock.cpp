#include <algorithm>
#include <cstdio>

#include "base/decimal.hpp"
#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_words.hpp"
#include "job/facts_of_stock.hpp"
#include "job/stock_run.hpp"
#include "machine/definition/tools/tool_comment.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "motion/feed.hpp"
#include "output/reports/stock_report.hpp"
#include "output/reports/stock_rows.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

const std::string kUsualStock = "extents";

job::StockModel model_named(const std::string& name) {
  if (name == "zmap") return job::StockModel::zmap;
  if (name == "profile") return job::StockModel::profile;
  if (name == "sheet") return job::StockModel::sheet;
  return name == "tridexel" ? job::StockModel::tridexel : job::StockModel::automatic;
}

/// Standard input is read once and kept: the program may be run several times.
Outcome<base::ProgramText> kept(const std::string& path) {
  if (path != "-") return base::ProgramText::at_path(path);
  constexpr std::size_t kLargest = 1UL << 30;
  auto text = base::read_whole(path, kLargest, "a program");
  if (!text) return tl::unexpected(text.error());
  return base::ProgramText::of(path, std::move(*text));
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
Outcome<std::optional<double>> kerf_of(const StockOptions& options) {
  if (options.kerf.empty()) return std::optional<double>{};
  const double kerf = base::read_number(options.kerf).value_or(0);
  if (!(kerf > 0)) return base::usage("--kerf " + options.kerf + ": a cut has a width");
  return std::optional(kerf);
}

Outcome<void> take_words(const StockOptions& options, job::StockJob& job) {
  auto material = material_of(options.material);
  if (!material) return tl::unexpected(material.error());
  job.material = *material;
  auto left_out = left_out_of(options.no_checks);
  if (!left_out) return tl::unexpected(left_out.error());
  job.left_out = std::move(*left_out);
  auto until = until_of(options.until);
  if (!until) return tl::unexpected(until.error());
  job.until = *until;
  job.has_real_lengths = options.lengths == "real";
  job.follows_set_points = options.path == "interpolated";
  job.stops_at_finding = options.stop_at_finding;
  return {};
}

Outcome<job::StockJob> stock_job(const StockOptions& options, OrderedJob ordered,
                                 base::ProgramText program, const base::SourceFile& source) {
  job::StockJob job{.job = std::move(ordered.job)};
  job.job.program = std::move(program);
  auto shape = machine::stock_word(options.stock.empty() ? kUsualStock : options.stock, "--stock");
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
  if (auto said = take_words(options, job); !said) return tl::unexpected(said.error());
  auto library = tools_of(options.run);
  if (!library) return tl::unexpected(library.error());
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

/// Rows of `--blocks` for each pass over the program: the file begins anew.
void write_rows(const StockOptions& options, std::optional<base::Failure>& failure,
                job::StockJob& job) {
  if (options.blocks.empty()) return;
  job.rows = [&](const job::Run& run) -> std::unique_ptr<stock::TimedCutSink> {
    auto file = base::OutputFile::create(options.blocks);
    if (!file) {
      failure = file.error();
      return nullptr;
    }
    return std::make_unique<output::StockRows>(std::move(*file), run.machine().sources());
  };
}

Outcome<void> commit_rows(const std::optional<base::Failure>& failure,
                          job::StockResult& result) {
  if (failure) return tl::unexpected(*failure);
  auto* const rows = dynamic_cast<output::StockRows*>(result.rows.get());
  return rows == nullptr ? Outcome<void>{} : rows->commit();
}

void tell_findings(const StockOptions& options, const output::StockFacts& facts,
                   const base::SourceSet& sources) {
  if (options.run.diagnostics != DiagnosticFormat::json) {
    const std::string text = output::stock_report_text(facts, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
    return;
  }
  for (const output::StockFacts::Told& told : facts.findings) {
    const std::string text = output::diagnostic_json(told.diagnostic, sources);
    std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

bool fails(const StockOptions& options, const output::StockFacts& facts) {
  if (options.fail_on == "never") return false;
  const bool errors_only = options.fail_on == "error";
  return std::any_of(facts.findings.begin(), facts.findings.end(), [&](const auto& told) {
    return !errors_only || told.diagnostic.severity == base::Severity::error;
  });
}

}  // namespace

ExitStatus stock(const StockOptions& options) {
  auto program = kept(options.run.program);
  if (!program) return fail(program.error());
  auto source = program->open();
  if (!source) return fail(source.error());
  auto ordered = job_of(options.run, **source);
  if (!ordered) return fail(ordered.error());
  ReadyRun ready{nullptr, ordered->choice, ordered->hint};
  auto job = stock_job(options, std::move(*ordered), std::move(*program), **source);
  if (!job) return fail(job.error());
  std::optional<base::Failure> no_rows;
  write_rows(options, no_rows, *job);
  auto cut = job::cut_stock(*job);
  if (!cut) return fail(cut.error());
  if (auto rows = commit_rows(no_rows, *cut); !rows) return fail(rows.error());
  output::StockFacts facts = job::facts_of(*cut);
  facts.shape = options.stock.empty() ? kUsualStock : options.stock;
  facts.run.chosen = ready.choice.chosen;
  ready.run = std::move(cut->run);
  const base::SourceSet& sources = ready.machine().sources();
  if (!options.report.empty()) {
    auto file = base::OutputFile::create(options.report);
    if (!file) return fail(file.error());
    (*file)->write(output::stock_report_json(facts, sources));
    if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  }
  report_diagnostics(ready, options.run.diagnostics);
  tell_findings(options, facts, sources);
  const ExitStatus ended = exit_status_of(cut->status);
  return ended == ExitStatus::well && fails(options, facts) ? ExitStatus::findings : ended;
}

}  // namespace kerf::cli
