#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/dialect_choice.hpp"
#include "job/job.hpp"
#include "job/run.hpp"
#include "output/reports/run_facts.hpp"

namespace kerf::cli {

/// What the words of a command line come to: a job, and how its machine was chosen.
struct OrderedJob {
  job::Job job;
  DialectChoice choice;
  /// LATHE_PROGRAM, of a program for a lathe on another machine.
  std::optional<base::Diagnostic> hint{};
};

/// The job that `kerf run` makes of its options. Failure (usage): an option is wrong; (input): a
/// file of settings cannot be read. `program` is the one that the options name.
[[nodiscard]] base::Outcome<OrderedJob> job_of(const RunOptions& options,
                                               const base::SourceFile& program);

/// A run with the program loaded, and how its machine was chosen.
struct ReadyRun {
  std::unique_ptr<job::Run> run;
  DialectChoice choice{};
  std::optional<base::Diagnostic> hint{};

  [[nodiscard]] machine::BatchRun& machine() const { return run->machine(); }
  /// The first alarm of the run, which also says for which machine the program looks to be.
  [[nodiscard]] std::optional<base::Diagnostic> alarm() const;
};

[[nodiscard]] base::Outcome<ReadyRun> make_ready(const RunOptions& options);
/// What the run came to, with how its machine was chosen.
[[nodiscard]] output::RunFacts facts_of(const ReadyRun& ready);
/// What a check asks of one of its files.
[[nodiscard]] RunOptions options_of(const std::string& path, const CheckOptions& options);
/// Of one file of a check, which goes on behind its alarms.
[[nodiscard]] base::Outcome<ReadyRun> make_ready(const std::string& path,
                                                 const CheckOptions& options);

/// How the command ends when the run ended so.
[[nodiscard]] ExitStatus exit_status_of(machine::RunStatus status);

}  // namespace kerf::cli
