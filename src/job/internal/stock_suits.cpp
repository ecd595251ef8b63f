#include "job/internal/stock_suits.hpp"

namespace kerf::job {

base::Outcome<void> suits(const StockJob& job) {
  const machine::MachineDefinition& machine = job.job.definition;
  if (job.model == StockModel::profile && !machine.turns())
    return base::usage("--model profile: only stock that a lathe turns has a profile");
  if (machine.axes.linked && !machine.axes.beam)
    return base::usage(machine.name + ": stock is cut on mills, lathes and lasers");
  return {};
}

base::Outcome<void> suits(const StockJob& job, const StockPlan& plan) {
  if (!job.job.definition.turns() || plan.kind == StockModel::profile) return {};
  return base::usage(
      "the part of a lathe is a bar about its spindle, cut by tools that stand still: " +
      plan.reason);
}

base::Outcome<void> without_beam(const StockJob& job) {
  if (std::holds_alternative<machine::StockSheet>(job.shape))
    return base::usage("--stock sheet: this machine has no laser");
  if (job.model == StockModel::sheet)
    return base::usage("--model sheet: this machine has no laser");
  if (job.kerf_mm) return base::usage("--kerf: this machine has no laser");
  return {};
}

}  // namespace kerf::job
