#include "face/cli/check_pattern.hpp"

#include <chrono>

#include "base/decimal.hpp"
#include "drive/pattern/reader.hpp"
#include "engraver/pattern_replay.hpp"
#include "face/cli/pattern_files.hpp"

namespace kerf::cli {
namespace {

using base::Diagnostic;

Diagnostic warning_at(base::Code code, std::uint64_t offset, const std::string& detail) {
  Diagnostic warning = base::make_error(code, {.file = kPatternFile}, detail);
  warning.severity = base::Severity::warning;
  warning.offset = offset;
  return warning;
}

/// A pattern that runs on a machine without any output, up to its first mistake.
class Trial {
 public:
  Trial(const CheckOptions& options, const base::SourceSet& sources,
        const machine::PatternMachine& machine, FileReport& report)
      : options_(options), sources_(sources), replay_(machine), report_(report) {}

  void run(drive::PatternReader& reader) {
    for (;;) {
      auto record = reader.next();
      if (!record) return report_.add(record.error(), sources_);
      if (!*record) return;
      if (is_spent()) return tell_spent(reader.offset());
      auto made = replay_.take(**record);
      if (made) continue;
      made.error().place.file = kPatternFile;
      made.error().offset = reader.offset();
      return report_.add(made.error(), sources_);
    }
  }
  void tell_travel() {
    for (const auto& [sentence, record] : replay_.beyond_travel())
      report_.add(warning_at(base::Code::joint_limit, (record - 1) * drive::kRecordBytes,
                             "record " + std::to_string(record) + ": " + sentence),
                  sources_);
  }

 private:
  [[nodiscard]] bool is_spent() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return (options_.max_seconds > 0 && elapsed.count() > options_.max_seconds) ||
           (options_.max_motions > 0 && replay_.statistics().motions() >= options_.max_motions);
  }
  void tell_spent(std::uint64_t offset) {
    report_.budget_spent = true;
    report_.add(
        warning_at(base::Code::budget_spent, offset, "what is allowed for a file is used up"),
        sources_);
  }

  const CheckOptions& options_;
  const base::SourceSet& sources_;
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
  drive::PatternReader reader(sources[kPatternFile], kPatternFile,
                              format_of(usual, definition->pattern.byte_order));
  Trial trial(options, sources, *machine, report);
  trial.run(reader);
  trial.tell_travel();
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
