#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "face/cli/check_pattern.hpp"
#include "face/cli/check_report.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/dialect_choice.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/drive_alarm.hpp"

namespace kerf::cli {
namespace {

using base::Diagnostic;
using machine::BatchRun;

bool same_mistake(const Diagnostic& a, const Diagnostic& b) {
  return a.place.file == b.place.file && a.place.line == b.place.line && a.number == b.number;
}

// What shows without running, reached or not, then what the run itself raises, also behind the
// first alarm, at which a control would stop.
std::vector<Diagnostic> find_all(const ReadyRun& ready, double max_seconds) {
  BatchRun& machine = ready.machine();
  base::Findings checked(base::Findings::kAll, base::WorkLimit(max_seconds));
  machine.check(checked);
  std::vector<Diagnostic> found = checked.list();
  ready.run->go();
  const auto add = [&](const std::optional<Diagnostic>& told) {
    if (!told) return;
    const auto same = [&](const Diagnostic& d) { return same_mistake(d, *told); };
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(*told);
  };
  if (ready.hint) add(output::at_line(*ready.hint, machine.sources()));
  for (const Diagnostic& alarm : machine.alarm_search()->findings()) add(alarm);
  add(ready.alarm());
  add(machine.notice());
  for (const Diagnostic& warning : machine.control().warnings()) add(warning);
  for (const Diagnostic& warning : machine.warnings())
    add(output::at_line(warning, machine.sources()));
  return found;
}

// What the stock says of the program; --fail-on says what of it counts.
base::Outcome<void> check_table(const std::string& path, const CheckOptions& options,
                                FileReport& report) {
  const auto on_table = has_table(options.table);
  if (!on_table) return tl::unexpected(on_table.error());
  if (!*on_table) return {};
  RunOptions of_file = options_of(path, options);
  of_file.table.jobs = options.jobs > 1 ? 1 : 0;
  const auto table = run_on_table(of_file);
  if (!table) return tl::unexpected(table.error());
  const base::SourceSet& sources = table->cut.run->machine().sources();
  for (const output::StockFacts::Told& told : table->facts.findings)
    report.add(told.diagnostic, sources, counts(table->set_up, told));
  return {};
}

FileReport check_file(const std::string& path, const CheckOptions& options) {
  if (is_pattern(options.dialect, path)) return check_pattern(path, options);
  FileReport report;
  report.file = path;
  auto ready = make_ready(path, options);
  if (!ready) {
    report.failure = ready.error();
    return report;
  }
  for (const Diagnostic& diagnostic : find_all(*ready, options.max_seconds))
    report.add(diagnostic, ready->machine().sources());
  if (auto looked = check_table(path, options, report); !looked) report.failure = looked.error();
  report.budget_spent =
      std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
        return finding.object["code"] == base::text_of(base::Code::budget_spent).number;
      });
  return report;
}

std::vector<FileReport> check_all(const CheckOptions& options) {
  std::vector<FileReport> reports(options.files.size());
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr fault;  // of any worker: main() tells it
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < options.files.size(); i = next++)
        reports[i] = check_file(options.files[i], options);
    } catch (...) {
      const std::lock_guard lock(guard);
      fault = std::current_exception();
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < std::min<std::size_t>(options.jobs, options.files.size()); ++i)
    workers.emplace_back(work);
  work();
  workers.clear();
  if (fault) std::rethrow_exception(fault);
  return reports;
}

// A file that cannot be checked counts most, then mistakes, then a program without an end.
ExitStatus status_of_all(const std::vector<FileReport>& reports) {
  const auto any = [&](const auto& condition) {
    return std::any_of(reports.begin(), reports.end(), condition);
  };
  const auto failed = std::find_if(reports.begin(), reports.end(),
                                   [](const FileReport& r) { return r.failure.has_value(); });
  if (failed != reports.end()) return status_of(*failed->failure);
  const auto mistakes = [](const FileReport& r) {
    return std::any_of(r.findings.begin(), r.findings.end(), [](const Finding& finding) {
      return finding.counts &&
             finding.object["code"] != base::text_of(base::Code::budget_spent).number;
    });
  };
  if (any(mistakes)) return ExitStatus::findings;
  if (any([](const FileReport& r) { return r.budget_spent; })) return ExitStatus::budget;
  return ExitStatus::well;
}

}  // namespace

ExitStatus check(const CheckOptions& options) {
  const std::vector<FileReport> reports = check_all(options);
  const std::string text = in_format(reports, options.format);
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::set<std::string> told;  // an option that is wrong is so for every file
  for (const FileReport& report : reports) {
    if (report.failure && told.insert(report.failure->message).second) fail(*report.failure);
  }
  return status_of_all(reports);
}

}  // namespace kerf::cli
