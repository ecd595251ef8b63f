#include "face/cli/internal/other_run.hpp"

#include <utility>

#include "base/source_file.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "job/part_file.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

/// Failure (usage): it is the program itself, or no program at all.
Outcome<void> check_against(const StockOptions& options) {
  const std::string& other = options.compare.against;
  if (other == "-" && options.run.program == "-")
    return base::usage("--against -: standard input is the program itself");
  const bool is_itself = is_same_file(other, options.run.program);
  if (is_itself && options.compare.against_tools.empty())
    return base::usage("--against " + other +
                       ": is the program itself, --against-tools names other tools for it");
  if (other.ends_with(".stl") || other.ends_with(".STL"))
    return base::usage("--against " + other +
                       ": a program or a .kstock is expected, --design compares with an STL");
  return {};
}

/// The saved part in a file; null: it is none.
Outcome<std::unique_ptr<base::SourceFile>> saved_part(const std::string& path) {
  if (path == "-") return nullptr;
  auto file = base::SourceFile::open(path);
  if (!file) return tl::unexpected(file.error());
  if (!job::is_part(**file)) return nullptr;
  return std::move(*file);
}

}  // namespace

Outcome<OtherRun> OtherRun::of(const StockOptions& options, const machine::SetUp& set_up,
                               job::StockJob& job) {
  OtherRun other;
  other.name_ = options.compare.against;
  if (other.name_.empty()) return other;
  if (auto checked = check_against(options); !checked) return tl::unexpected(checked.error());
  auto saved = saved_part(other.name_);
  if (!saved) return tl::unexpected(saved.error());
  job.is_compared = true;
  if (*saved == nullptr) {
    if (auto ordered = other.order(options, set_up, job); !ordered)
      return tl::unexpected(ordered.error());
    return other;
  }
  if (!options.compare.against_tools.empty())
    return base::usage("--against-tools: " + other.name_ + " is a part that was cut, no program");
  auto part = job::read_other(**saved, job);
  if (!part) return tl::unexpected(part.error());
  other.part_ = std::move(*part);
  return other;
}

Outcome<void> OtherRun::order(const StockOptions& options, const machine::SetUp& set_up,
                              job::StockJob& job) {
  RunOptions run = options.run;
  run.program = name_;
  if (!options.compare.against_tools.empty()) run.tools = options.compare.against_tools;
  auto program = kept_program(name_);
  if (!program) return tl::unexpected(program.error());
  auto source = program->open();
  if (!source) return tl::unexpected(source.error());
  auto ordered = job_of(run, **source);
  if (!ordered) return tl::unexpected(ordered.error());
  const std::string& here = job.job.definition.name;
  const std::string& there = ordered->job.definition.name;
  if (here != there)
    return base::usage("--against " + name_ + ": it is a program for " + there + ", and " +
                       options.run.program + " one for " + here +
                       "; --machine says where both shall run");
  ready_ = {nullptr, ordered->choice, ordered->hint};
  auto other = stock_job(run, set_up, std::move(*ordered), std::move(*program), **source);
  if (!other) return tl::unexpected(other.error());
  other->follows_set_points = job.follows_set_points;
  other->stops_at_finding = job.stops_at_finding;
  if (other->knows_stock && other->said != job.said)
    job.notes.push_back("the stock of " + name_ + " is that of " + options.run.program);
  if (job.until) job.notes.push_back(name_ + " is cut to its end");
  job::share_memory(job);
  order_ = std::move(*other);
  return {};
}

Outcome<void> OtherRun::cut(job::StockJob& job, job::StockResult& result) {
  if (!order_) return {};
  auto part = job::cut_other(job, result, std::move(*order_), name_);
  if (!part) return tl::unexpected(part.error());
  part_ = std::move(*part);
  return {};
}

Outcome<void> OtherRun::compare(const job::StockJob& job, job::StockResult& result) {
  return part_ ? job::compare_with_other(job, *part_, result) : Outcome<void>{};
}

ExitStatus OtherRun::report(DiagnosticFormat format) {
  if (!part_ || !part_->cut) return ExitStatus::well;
  ready_.run = std::move(part_->cut->run);
  report_diagnostics(ready_, format);
  return exit_status_of(part_->cut->status);
}

}  // namespace kerf::cli
