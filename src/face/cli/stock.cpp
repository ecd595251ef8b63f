#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/output_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/internal/other_run.hpp"
#include "face/cli/internal/stock_words.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_files.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "job/facts_of_stock.hpp"
#include "job/part_comparison.hpp"
#include "job/stock_run.hpp"
#include "output/reports/stock_report.hpp"
#include "output/reports/stock_rows.hpp"
#include "output/reports/summary.hpp"

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

/// What the table and the words of a comparison say together.
base::Outcome<machine::SetUp> whole_set_up(const StockOptions& options) {
  auto set_up = set_up_of(options.run.table);
  if (!set_up) return set_up;
  return with_design(options.compare, std::move(*set_up));
}

/// What the part is compared with, and how closely.
base::Outcome<void> take_comparison(const CompareOptions& options,
                                    const std::optional<machine::SetUp::Design>& design,
                                    job::StockJob& job) {
  if (auto checked = check_comparison(options, design); !checked) return checked;
  auto tolerance = tolerance_of(options, design);
  if (!tolerance) return tl::unexpected(tolerance.error());
  job.tolerance = *tolerance;
  return design ? job::read_design(*design, job) : base::Outcome<void>{};
}

/// What a command reads, none of which may be written.
std::vector<std::string> inputs_of(const StockOptions& options, const machine::SetUp& set_up) {
  std::vector<std::string> inputs = set_up.files();
  for (const std::string* const input :
       {&options.run.program, &options.run.tools, &options.run.offsets, &options.run.state,
        &options.run.table.set_up, &options.compare.against, &options.compare.against_tools})
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

/// A run that is made ready, and what it is compared with.
struct OrderedStock {
  machine::SetUp set_up;
  std::vector<std::string> inputs;
  ReadyRun ready;
  job::StockJob job;
  OtherRun other;
};

base::Outcome<OrderedStock> order_stock(const StockOptions& options) {
  auto set_up = whole_set_up(options);
  if (!set_up) return tl::unexpected(set_up.error());
  std::vector<std::string> inputs = inputs_of(options, *set_up);
  const auto design = std::exchange(set_up->design, std::nullopt);
  auto order = order_on_table(options.run, std::move(*set_up));
  if (!order) return tl::unexpected(order.error());
  job::StockJob& job = order->job;
  if (auto taken = take_words(options, job); !taken) return tl::unexpected(taken.error());
  if (auto taken = take_comparison(options.compare, design, job); !taken)
    return tl::unexpected(taken.error());
  auto other = OtherRun::of(options, order->set_up, job);
  if (!other) return tl::unexpected(other.error());
  return OrderedStock{std::move(order->set_up), std::move(inputs), std::move(order->ready),
                      std::move(job), std::move(*other)};
}

base::Outcome<job::StockResult> cut_and_compare(const StockOptions& options,
                                                OrderedStock& ordered) {
  std::optional<base::Failure> no_rows;
  write_rows(options, no_rows, ordered.job);
  auto cut = job::cut_stock(ordered.job);
  if (!cut) return cut;
  if (auto done = ordered.other.cut(ordered.job, *cut); !done) return tl::unexpected(done.error());
  if (auto rows = commit_rows(no_rows, *cut); !rows) return tl::unexpected(rows.error());
  if (auto compared = job::compare_with_design(ordered.job, *cut); !compared)
    return tl::unexpected(compared.error());
  if (auto compared = ordered.other.compare(ordered.job, *cut); !compared)
    return tl::unexpected(compared.error());
  return cut;
}

base::Outcome<void> write_report(const std::string& path, const output::StockFacts& facts,
                                 const base::SourceSet& sources) {
  if (path.empty()) return {};
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  (*file)->write(output::stock_report_json(facts, sources));
  return (*file)->commit();
}

/// That of the program counts most, then that of the other one, then findings.
ExitStatus status_of_both(ExitStatus here, ExitStatus there, bool fails) {
  if (here != ExitStatus::well) return here;
  if (there != ExitStatus::well) return there;
  return fails ? ExitStatus::findings : ExitStatus::well;
}

}  // namespace

ExitStatus stock(const StockOptions& options) {
  auto ordered = order_stock(options);
  if (!ordered) return fail(ordered.error());
  StockFiles files(options.files);
  if (auto apart = keep_apart(options, ordered->inputs); !apart) return fail(apart.error());
  for (const std::string& input : ordered->inputs) files.keep_from(input);
  if (auto opened = files.open(ordered->job); !opened) return fail(opened.error());
  ordered->job.keeps_ways = files.needs_ways();
  auto cut = cut_and_compare(options, *ordered);
  if (!cut) return fail(cut.error());
  ReadyRun& ready = ordered->ready;
  output::StockFacts facts = job::facts_of(*cut);
  facts.shape = ordered->job.said;
  facts.run.chosen = ready.choice.chosen;
  if (auto written = files.write(*cut, facts, ordered->job, ordered->other.part()); !written)
    return fail(written.error());
  ready.run = std::move(cut->run);
  const base::SourceSet& sources = ready.machine().sources();
  if (auto written = write_report(options.report, facts, sources); !written)
    return fail(written.error());
  report_diagnostics(ready, options.run.diagnostics);
  const ExitStatus there = ordered->other.report(options.run.diagnostics);
  const bool for_people = options.run.diagnostics != DiagnosticFormat::json;
  if (for_people) std::fputs(output::summary_text(facts.run).c_str(), stderr);
  report_stock(options.run, facts, sources);
  if (for_people) std::fputs(files.remarks().c_str(), stderr);
  return status_of_both(exit_status_of(cut->status), there, fails(ordered->set_up, facts));
}

}  // namespace kerf::cli
