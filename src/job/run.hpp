#pragma once

#include <memory>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "job/job.hpp"
#include "machine/run/batch_run.hpp"
#include "machine/run/known_skips.hpp"
#include "machine/run/stepper.hpp"

namespace kerf::job {

/// A job that is under way: a machine with the program loaded and everything set.
class Run {
 public:
  /// Failure (usage): the machine does not run the language, a variable cannot be set, the budget
  /// is spent before an interrupt comes. Failure (input): the program or a library folder cannot be
  /// read. `program`: the job's, where it is open already; null: it is opened.
  [[nodiscard]] static base::Outcome<std::unique_ptr<Run>> of(
      const Job& job, std::unique_ptr<base::SourceFile> program = nullptr);

  [[nodiscard]] machine::BatchRun& machine() { return machine_; }
  [[nodiscard]] const machine::BatchRun& machine() const { return machine_; }
  /// To the end, within the job's budget.
  machine::RunStatus go() { return machine_.run_to_end(budget_); }

 private:
  explicit Run(const Job& job);
  [[nodiscard]] base::Outcome<void> plan_interrupts(const Job& job);

  machine::Budget budget_;
  machine::KnownSkips skips_;
  machine::BatchRun machine_;
  std::unique_ptr<machine::Stepper> interrupts_;  // gives the machine its signals; null: none
};

}  // namespace kerf::job
