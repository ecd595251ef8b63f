#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "face/cli/exit_status.hpp"
#include "face/cli/ready_run.hpp"
#include "job/other_part.hpp"
#include "job/stock_job.hpp"
#include "machine/definition/set_up.hpp"

namespace kerf::cli {

/// What `--against` names, from its words to the part; without the option none of it does
/// anything.
class OtherRun {
 public:
  /// Reads it, and leaves room for it in the memory of `job`, which is that of the program itself
  /// and has run nothing yet. Failure (usage): nothing that could be compared; (input): it cannot
  /// be read.
  [[nodiscard]] static base::Outcome<OtherRun> of(const StockOptions& options,
                                                  const machine::SetUp& set_up, job::StockJob& job);

  /// Cuts the other part, where it is a program's, and perhaps the first one again.
  [[nodiscard]] base::Outcome<void> cut(job::StockJob& job, job::StockResult& result);
  [[nodiscard]] base::Outcome<void> compare(const job::StockJob& job, job::StockResult& result);
  /// Null: there is none.
  [[nodiscard]] const job::OtherPart* part() const { return part_ ? &*part_ : nullptr; }

  /// Tells on standard error what the other run has to say; how it ended. Once, at the end.
  [[nodiscard]] ExitStatus report(DiagnosticFormat format);

 private:
  [[nodiscard]] base::Outcome<void> order(const StockOptions& options, const machine::SetUp& set_up,
                                          job::StockJob& job);

  std::string name_;
  std::optional<job::StockJob> order_;  // of a program
  ReadyRun ready_{};                    // how its machine was chosen
  std::optional<job::OtherPart> part_;
};

}  // namespace kerf::cli
