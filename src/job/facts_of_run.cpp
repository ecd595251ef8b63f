#include "job/facts_of_run.hpp"

#include "base/program_name.hpp"
#include "machine/dialect/registry.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/drive_alarm.hpp"
#include "output/writing/title.hpp"

namespace kerf::job {
namespace {

using machine::BatchRun;
using machine::RunStatus;
using output::RunFacts;

RunFacts::Status status_of(RunStatus status) {
  switch (status) {
    case RunStatus::idle: return RunFacts::Status::idle;
    case RunStatus::running:
    case RunStatus::stopped: return RunFacts::Status::stopped;
    case RunStatus::end: return RunFacts::Status::end;
    case RunStatus::alarm: return RunFacts::Status::alarm;
    case RunStatus::budget: return RunFacts::Status::budget;
  }
  return RunFacts::Status::idle;
}

std::string main_file(const BatchRun& machine) {
  const base::FileId first{0};
  return machine.sources().contains(first) ? machine.sources()[first].name() : std::string();
}

RunFacts::Alarm alarm_facts(const base::Diagnostic& alarm, const base::SourceSet& sources) {
  return {.number = alarm.number,
          .message = alarm.message,
          .file = output::file_name(alarm, sources),
          .program = alarm.program,
          .line = alarm.place.line,
          .column = alarm.place.column};
}

std::vector<RunFacts::Axis> axes_of(const BatchRun& machine) {
  const motion::AxisSetup& axes = machine.definition().axes;
  const base::MachinePoint at = machine.position();
  const base::AxisVector work = at.numbers() - machine.control().work_origin();
  std::vector<RunFacts::Axis> list;
  for (std::size_t i = 0; i < axes.count(); ++i) {
    const double count = axes.axes[i].count_per_mm();
    list.push_back({.letter = axes.axes[i].letter,
                    .low = machine.statistics().low().values[i] * count,
                    .high = machine.statistics().high().values[i] * count,
                    .work = work.values[i] * count,
                    .machine = at.values[i] * count});
  }
  return list;
}

std::vector<control::Assumption> assumed_by(const BatchRun& machine) {
  std::vector<control::Assumption> list = machine.control().assumptions().list();
  if (const std::uint32_t line = machine.statistics().untimed_line(); line != 0) {
    list.push_back({line, "feed per revolution without a spindle speed: its time is not counted"});
  }
  return list;
}

RunFacts::Turning turning_of(const BatchRun& machine) {
  const machine::TurningStatistics& run = machine.turning_statistics();
  RunFacts::Turning turning;
  for (std::size_t i = 0; i < motion::kSpindles; ++i) {
    const auto name = static_cast<motion::SpindleName>(i);
    const auto& use = run.use_of(name);
    if (name == motion::SpindleName::main || use.turned)
      turning.spindles.push_back(
          {std::string(name_of(name)), use.most_rpm, use.css, use.is_clamped});
  }
  for (const auto& thread : run.threads())
    turning.threads.push_back({thread.lead, thread.passes, thread.depth});
  turning.cycles = machine.control().cycles();
  return turning;
}

}  // namespace

RunFacts facts_of(BatchRun& machine) {
  RunFacts facts;
  facts.program = machine.program_name();
  facts.title = title_of(machine);
  facts.file = main_file(machine);
  facts.machine = machine.definition().name;
  facts.dialect = machine.dialect();
  facts.status = status_of(machine.status());
  if (machine.alarm()) facts.alarm = alarm_facts(*machine.alarm(), machine.sources());
  facts.blocks = machine.control().blocks();
  const machine::RunStatistics& run = machine.statistics();
  facts.motions = run.motions();
  facts.time_s = machine.time_s();
  facts.feed_s = run.feed_seconds();
  facts.dwell_s = run.dwell_seconds();
  facts.rapid_mm = run.rapid_mm();
  facts.cut_mm = run.cut_mm();
  facts.axes = axes_of(machine);
  facts.tools = run.tools();
  facts.messages = run.messages();
  facts.parts = machine.memory().parts;
  if (machine.dialect() == machine::kLatheDialect) facts.turning = turning_of(machine);
  facts.assumed = assumed_by(machine);
  for (const machine::Variable& variable : machine.variables())
    facts.variables.emplace_back(variable.name, variable.value);
  return facts;
}

std::string title_of(const BatchRun& machine) {
  return output::program_title(machine.program_name(), main_file(machine));
}

std::string source_of(const BatchRun& machine) {
  const bool is_unknown = machine.dialect() == machine::kMotionDialect &&
                          machine.program_name() == base::kUnnumberedProgram;
  return is_unknown ? std::string() : title_of(machine);
}

output::DriveFault alarm_of(BatchRun& machine) {
  return [&machine](const base::Diagnostic& alarm, const motion::Mark& mark) {
    machine.raise(output::at_mark(alarm, mark, machine.sources()));
  };
}

}  // namespace kerf::job
