#include "job/run.hpp"

#include <algorithm>
#include <filesystem>

#include "machine/dialect/dialect.hpp"
#include "machine/run/interrupt_plan.hpp"

namespace kerf::job {
namespace {

using base::Failure;
using base::Outcome;

Outcome<void> check_folders(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    std::error_code error;
    const std::filesystem::directory_iterator readable(folder, error);
    if (error)
      return tl::unexpected(Failure{Failure::Kind::input, folder + ": " + error.message()});
  }
  return {};
}

Outcome<void> set_variables(const Job& job, machine::Machine& machine) {
  for (const InitialVariable& variable : job.variables) {
    if (auto set = machine.set_variable(variable.name, variable.value); !set)
      return tl::unexpected(
          Failure{Failure::Kind::usage, variable.said + ": " + set.error().message});
  }
  return {};
}

Outcome<void> prepare(const Job& job, std::unique_ptr<base::SourceFile> program,
                      machine::Machine& machine) {
  if (!program) {
    auto opened = job.program.open();
    if (!opened) return tl::unexpected(opened.error());
    program = std::move(*opened);
  }
  machine.load(std::move(program));
  if (job.input)
    machine.set_input(
        [input = job.input, line = std::size_t{0}]() mutable { return input(line++); });
  for (const machine::SkipContact& contact : job.contacts) machine.add_skip_contact(contact);
  return set_variables(job, machine);
}

Outcome<std::unique_ptr<machine::PacedRun>> make_paced(const Job& job) {
  auto made = std::make_unique<machine::PacedRun>(job.definition, job.memory, job.settings);
  if (auto prepared = prepare(job, nullptr, *made); !prepared)
    return tl::unexpected(prepared.error());
  return made;
}

}  // namespace

Run::Run(const Job& job)
    : budget_(job.budget), skips_(job.skips), machine_(job.definition, job.memory, job.settings) {
  machine_.set_skip_signal(skips_);
}

// When the axes are where is only known of a run by time: such ones are made before.
Outcome<void> Run::plan_interrupts(const Job& job) {
  std::vector<double> times_s = job.interrupt_at_s;
  std::sort(times_s.begin(), times_s.end());
  const auto plan =
      machine::plan_interrupts([&job] { return make_paced(job); }, times_s, job.budget.seconds);
  if (!plan) return tl::unexpected(plan.error());
  interrupts_ = std::make_unique<machine::Stepper>(machine_.language());
  for (const std::uint64_t block : plan->blocks)
    interrupts_->before_block(block, [this] { machine_.control().interrupt(); });
  for (std::size_t i = 0; i < plan->late; ++i) machine_.control().miss_interrupt();
  return {};
}

Outcome<std::unique_ptr<Run>> Run::of(const Job& job, std::unique_ptr<base::SourceFile> program) {
  const std::string& dialect =
      job.settings.dialect.empty() ? job.definition.dialect : job.settings.dialect;
  if (auto known = machine::check_dialect(job.definition, dialect); !known)
    return tl::unexpected(known.error());
  if (auto readable = check_folders(job.settings.library_folders); !readable)
    return tl::unexpected(readable.error());
  std::unique_ptr<Run> run(new Run(job));
  if (auto prepared = prepare(job, std::move(program), run->machine_); !prepared)
    return tl::unexpected(prepared.error());
  if (job.behind_alarms) run->machine_.search_alarms();
  if (job.interrupt_at_s.empty()) return run;
  if (auto planned = run->plan_interrupts(job); !planned) return tl::unexpected(planned.error());
  return run;
}

}  // namespace kerf::job
