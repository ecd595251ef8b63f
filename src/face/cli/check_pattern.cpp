#include "face/cli/check_pattern.hpp"

#include <chrono>

#include "base/decimal.hpp"
#include "engraver/pattern_replay.hpp"
#include "face/cli/internal/pattern_play.hpp"
#include "face/cli/pattern_files.hpp"

namespace kerf::cli {
namespace {

using base::Diagnostic;

Diagnostic warning_of(base::Code code, const std::string& detail) {
  Diagnostic warning = base::make_error(code, {.file = kPatternFile}, detail);
  warning.severity = base::Severity::warning;
  return warning;
}

/// A pattern that runs on a machine without any output, up to its first mistake.
class Trial {
 public:
  Trial(const CheckOptions& options, const base::SourceSet& sources,
        const machine::PatternMachine& machine, FileReport& report)
      : options_(options),
        sources_(sources),
        file_(sources, machine.definition(),
              format_of({}, machine.definition().pattern.byte_order)),
        replay_(machine),
        report_(report) {}

  void run() {
    if (auto made = file_.run(*this); !made) report_.add(made.error(), sources_);
    tell_travel();
  }

  // For PatternPlay.
  [[nodiscard]] bool spent() {
    if (report_.budget_spent) return true;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const bool late = options_.max_seconds > 0 && elapsed.count() > options_.max_seconds;
    if (!late &&
        !(options_.max_motions > 0 && replay_.statistics().motions() >= options_.max_motions))
      return false;
    report_.budget_spent = true;
    Diagnostic warning =
        warning_of(base::Code::budget_spent, "what is allowed for a file is used up");
    file_.stand_here(warning);
    report_.add(warning, sources_);
    return true;
  }
  template <typename Record>
  base::Result<void> take(const Record& record) {
    auto made = replay_.take(record);
    if (!made) file_.stand_here(made.error());
    return made;
  }

 private:
  void tell_travel() {
    for (const auto& [sentence, record] : replay_.beyond_travel()) {
      Diagnostic warning =
          warning_of(base::Code::joint_limit, "record " + std::to_string(record) + ": " + sentence);
      if (file_.has_bytes()) warning.offset = (record - 1) * drive::kRecordBytes;
      report_.add(warning, sources_);
    }
  }

  const CheckOptions& options_;
  const base::SourceSet& sources_;
  PatternPlay file_;
  engraver::PatternReplay replay_;
  FileReport& report_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

base::Outcome<void> try_pattern(const CheckOptions& options, FileReport& report) {
  auto file = base::SourceFile::open(report.file);
  if (!file) return tl::unexpected(file.error());
  base::SourceSet sources;
  sources.add(std::move(*file));
  const PatternOptions usual;
  const auto definition =
      machine::find_machine(options.machine.empty() ? usual.machine : options.machine);
  if (!definition) return tl::unexpected(definition.error());
  const auto machine = machine::PatternMachine::of(*definition);
  if (!machine) return tl::unexpected(machine.error());
  Trial(options, sources, *machine, report).run();
  return {};
}

}  // namespace

FileReport check_pattern(const std::string& path, const CheckOptions& options) {
  FileReport report;
  report.file = path;
  if (auto tried = try_pattern(options, report); !tried) report.failure = tried.error();
  return report;
}

}  // namespace kerf::cli
