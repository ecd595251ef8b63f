#include "training/trial.hpp"

#include <array>
#include <optional>

#include "job/facts_of_run.hpp"
#include "job/run.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::training {
namespace {

using geometry::Vec3;
using Status = machine::RunStatus;

constexpr double kMostTimesFed = 20;
constexpr double kMostFedAnyway_mm = 2000;

// A program of an exercise is done in a part of these.
machine::Budget budget_of_run(const std::stop_token& unwanted) {
  return {.seconds = 5, .motions = 200'000, .steps = 5'000'000, .unwanted = unwanted};
}

CutRecorder::Work work_of(const Exercise& exercise) {
  const auto& [x, y, z] = exercise.zero_mm;
  return {process_of(exercise), Vec3{x, y, z}, exercise.bar_mm.value_or(0) / 2};
}

control::Memory memory_of(const Exercise& exercise, const machine::MachineDefinition& machine) {
  control::Memory memory(machine.parameters.n_offsets);
  constexpr std::array<char, 3> kLetters = {'X', 'Y', 'Z'};
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    if (const auto axis = machine.axes.find(kLetters[i]))
      memory.work[0][*axis] = exercise.zero_mm[i];
  }
  return memory;
}

void keep_diagnostic(Trial& trial, const std::optional<base::Diagnostic>& told) {
  if (!told) return;
  trial.code = told->number;
  trial.message = told->message;
  trial.line = told->place.line;
}

}  // namespace

bool Trial::has_ended() const {
  return (status == Status::end || status == Status::stopped) && !fed_too_far;
}

double most_fed_mm(double work_mm) { return kMostTimesFed * work_mm + kMostFedAnyway_mm; }

CutRecorder::Process process_of(const Exercise& exercise) {
  if (exercise.bar_mm) return CutRecorder::Process::turning;
  return exercise.clearance_z_mm ? CutRecorder::Process::milling : CutRecorder::Process::beam;
}

std::string dialect_of(const Exercise& exercise, const machine::MachineDefinition& definition) {
  const auto* const dialect = machine::dialect_by_ending(exercise.file);
  return dialect != nullptr ? std::string(dialect->name) : definition.dialect;
}

job::Job job_of(const Exercise& exercise, const machine::MachineDefinition& definition,
                const std::string& program, const std::stop_token& unwanted) {
  job::Job job{.definition = definition, .memory = memory_of(exercise, definition)};
  job.settings.dialect = dialect_of(exercise, definition);
  job.program = base::ProgramText::of(exercise.file, program);
  job.budget = budget_of_run(unwanted);
  return job;
}

Trial trial_of(const Exercise& exercise, const machine::MachineDefinition& definition,
               const std::string& program, double most_mm, const std::stop_token& unwanted) {
  Trial trial;
  const auto made = job::Run::of(job_of(exercise, definition, program, unwanted));
  if (!made) {
    trial.status = Status::alarm;
    trial.message = made.error().message;
    return trial;
  }
  machine::BatchRun& machine = (*made)->machine();
  CutRecorder recorder(definition, work_of(exercise), most_mm,
                       [&] { machine.raise(base::make_error(base::Code::budget_spent, {})); });
  machine.add_sink(recorder);
  trial.status = (*made)->go();
  trial.fed_too_far = recorder.is_full();
  keep_diagnostic(trial, trial.status == Status::alarm ? machine.alarm() : machine.notice());
  if (trial.line > 0) trial.file = exercise.file;
  trial.time_s = machine.time_s();
  trial.cuts = recorder.cuts();
  trial.strokes = recorder.strokes();
  trial.cut_mm = recorder.length();
  trial.fed_mm = recorder.fed();
  trial.motions = job::facts_of(machine).motions;
  return trial;
}

}  // namespace kerf::training
