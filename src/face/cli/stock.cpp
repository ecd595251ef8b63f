#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/internal/stock_words.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_files.hpp"
#include "face/cli/stock_order.hpp"
#include "job/facts_of_stock.hpp"
#include "job/part_comparison.hpp"
#include "job/stock_run.hpp"
#include "output/reports/stock_report.hpp"
#include "output/reports/stock_rows.hpp"

namespace kerf::cli {
namespace {

/// What `kerf stock` has besides a table.
base::Outcome<void> take_words(const StockOptions& options, job::StockJob& job) {
  auto until = until_of(options.until);
  if (!until) return tl::unexpected(until.error());
  job.until = *until;
  job.follows_set_points = options.path == "interpolated";
  job.stops_at_finding = options.stop_at_finding;
  return {};
}

/// What the part is compared with.
base::Outcome<void> take_design(const CompareOptions& options, job::StockJob& job) {
  if (auto checked = check_comparison(options); !checked) return checked;
  auto tolerance = tolerance_of(options);
  if (!tolerance) return tl::unexpected(tolerance.error());
  job.tolerance = *tolerance;
  if (options.design.empty()) return {};
  return job::read_design(options.design, {}, job);
}

/// What a command reads, none of which may be written.
std::vector<std::string> inputs_of(const StockOptions& options, const machine::SetUp& set_up) {
  std::vector<std::string> inputs = set_up.files();
  for (const std::string* const input :
       {&options.run.program, &options.run.tools, &options.run.offsets, &options.run.state,
        &options.run.table.set_up, &options.compare.design})
    inputs.push_back(*input);
  return inputs;
}

/// Failure (usage): a file that is written by itself is one of those.
base::Outcome<void> keep_apart(const StockOptions& options,
                               const std::vector<std::string>& inputs) {
  for (const std::string* const output : {&options.report, &options.blocks}) {
    for (const std::string& input : inputs) {
      if (!output->empty() && is_same_file(*output, input))
        return base::usage(*output + ": is read by this command, and cannot be its output");
    }
  }
  return {};
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

base::Outcome<void> commit_rows(const std::optional<base::Failure>& failure,
                                job::StockResult& result) {
  if (failure) return tl::unexpected(*failure);
  auto* const rows = dynamic_cast<output::StockRows*>(result.rows.get());
  return rows == nullptr ? base::Outcome<void>{} : rows->commit();
}

}  // namespace

ExitStatus stock(const StockOptions& options) {
  auto order = order_on_table(options.run);
  if (!order) return fail(order.error());
  auto& [set_up, ready, job] = *order;
  if (auto taken = take_words(options, job); !taken) return fail(taken.error());
  if (auto taken = take_design(options.compare, job); !taken) return fail(taken.error());
  StockFiles files(options.files);
  const std::vector<std::string> inputs = inputs_of(options, set_up);
  if (auto apart = keep_apart(options, inputs); !apart) return fail(apart.error());
  for (const std::string& input : inputs) files.keep_from(input);
  if (auto opened = files.open(job); !opened) return fail(opened.error());
  job.keeps_ways = files.needs_ways();
  std::optional<base::Failure> no_rows;
  write_rows(options, no_rows, job);
  auto cut = job::cut_stock(job);
  if (!cut) return fail(cut.error());
  if (auto rows = commit_rows(no_rows, *cut); !rows) return fail(rows.error());
  if (auto compared = job::compare_with_design(job, *cut); !compared) return fail(compared.error());
  output::StockFacts facts = job::facts_of(*cut);
  facts.shape = job.said;
  facts.run.chosen = ready.choice.chosen;
  if (auto written = files.write(*cut, facts, job); !written) return fail(written.error());
  ready.run = std::move(cut->run);
  const base::SourceSet& sources = ready.machine().sources();
  if (!options.report.empty()) {
    auto file = base::OutputFile::create(options.report);
    if (!file) return fail(file.error());
    (*file)->write(output::stock_report_json(facts, sources));
    if (auto committed = (*file)->commit(); !committed) return fail(committed.error());
  }
  report_diagnostics(ready, options.run.diagnostics);
  report_stock(options.run, facts, sources);
  if (options.run.diagnostics != DiagnosticFormat::json)
    std::fputs(files.remarks().c_str(), stderr);
  const ExitStatus ended = exit_status_of(cut->status);
  return ended == ExitStatus::well && fails(set_up, facts) ? ExitStatus::findings : ended;
}

}  // namespace kerf::cli
