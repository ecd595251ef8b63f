#include "job/internal/stock_suits.hpp"

namespace kerf::job {

base::Outcome<void> suits(const StockJob& job) {
  const machine::MachineDefinition& machine = job.job.definition;
  if (job.model == StockModel::profile && !machine.turns())
    return base::usage("--model profile: only stock that a lathe turns has a profile");
  if (job.model == StockModel::zmap && machine.turns())
    return base::usage("--model zmap: the part of a lathe is no height field; --model tridexel");
  if (machine.axes.linked && !machine.axes.beam)
    return base::usage(machine.name + ": stock is cut on mills, lathes and lasers");
  return {};
}

base::Outcome<void> suits(const StockJob& job, const StockPlan& plan) {
  if (!job.job.definition.turns()) return {};
  if (job.model == StockModel::profile && plan.kind != StockModel::profile)
    return base::usage("--model profile: " + plan.reason);
  if (plan.is_beside_middle)
    return base::usage(
        "a turning tool cuts beside the middle of the part, which no model can hold: " +
        plan.reason);
  return {};
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
