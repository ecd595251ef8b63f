#include "face/server/hub/internal/previews.hpp"

#include "face/server/hub/internal/console.hpp"
#include "face/server/hub/internal/program_source.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {

PreviewBasis PreviewBasis::of(Runner& runner) {
  machine::LiveMachine& machine = runner.machine();
  return {machine.definition_of_run(), machine.memory(), machine.snapshot()};
}

// The loaded program as cycle start would begin it now. A pattern begins at the zero of its motors,
// wherever they stand.
job::Job Previews::job_of(const MachineRecord& machine,
                          const machine::MachineDefinition& definition,
                          const control::Memory& memory) const {
  const std::string& dialect = machine.program->dialect;
  job::Job job{.definition = dialect == machine::kPatternDialect
                                 ? machine::PatternMachine::at_zero(definition)
                                 : definition,
               .memory = memory,
               .settings = {.dialect = dialect, .library_folders = {around_.library.folder()}}};
  if (!machine.snapshot) return job;
  job.settings.signals.set_inputs(machine.snapshot->inputs);
  job.settings.block_skip = machine.snapshot->panel.skip_levels;
  job.settings.optional_stop = machine.snapshot->panel[machine::Switch::optional_stop];
  return job;
}

// The newest snapshot that has come by itself may be older than what the operator has set since.
void Previews::start(MachineRecord& machine, const PreviewBasis& basis) {
  machine.snapshot = basis.snapshot;
  start(machine, basis.definition, basis.memory);
}

void Previews::start(MachineRecord& machine, const machine::MachineDefinition& definition,
                     const control::Memory& memory) {
  thread_.here();
  machine.cancel_preview();
  machine.preview.reset();
  machine.preview_began_ms = around_.clock.now_ms();
  if (!machine.program) return around_.parts.end(machine);
  PreviewOrder order{.job = job_of(machine, definition, memory),
                     .program = [&library = around_.library, program = *machine.program,
                                 definition] { return text_of(library, program, definition); },
                     .run = ++machine.preview_run};
  around_.parts.begin(machine, {machine.program->name, order.job, order.program});
  const auto preview = std::make_shared<Preview>(
      std::move(order), std::make_shared<ChunkStore>(around_.folder, chunk_budget_));
  tell_begin(machine, preview);
  around_.worker.post([this, preview, name = machine.name] { run(name, preview); });
}

void Previews::tell_begin(MachineRecord& machine, const std::shared_ptr<Preview>& preview) {
  machine.preview = preview;
  machine.path = PreviewState{machine.preview_run, false, {}, {}, nullptr};
  for (Client* const watcher : machine.watchers) {
    watcher->send(machine.path_event());
    watcher->begin_chunks(preview->chunks());
  }
  machine.touch();
}

// On a thread of the worker.
void Previews::run(const std::string& name, const std::shared_ptr<Preview>& preview) {
  const auto tell_state = [&](const PreviewState& state) {
    around_.answers.to_sockets([this, name, preview, state] { heard(name, preview, state); });
  };
  try {
    preview->run(tell_state);
  } catch (const std::exception& fault) {
    tell_console(name + ": the preview: fault of Kerf itself: " + fault.what());
  }
}

void Previews::heard(const std::string& name, const std::shared_ptr<Preview>& preview,
                     const PreviewState& state) {
  thread_.here();
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr || machine->preview != preview) return;  // of a program before this one
  machine->path = state;
  if (Json& error = machine->path->error; error.is_object())
    error["message"] = around_.answers.without_folder(error["message"].get<std::string>());
  for (Client* const watcher : machine->watchers) {
    watcher->send(machine->path_event());
    watcher->wake();
  }
  if (state.done) machine->touch();
}

void Previews::renew(const std::string& name) {
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr) return;
  machine->thread->post(machine->runner, Pace::quick, [this, name](Runner& runner) {
    around_.answers.to_sockets([this, name, basis = PreviewBasis::of(runner)] {
      if (MachineRecord* const found = around_.machines.find(name)) start(*found, basis);
    });
  });
}

void Previews::tick() {
  const double now_ms = around_.clock.now_ms();
  for (const auto& [name, machine] : around_.machines.records()) {
    if (!machine->wants_preview(now_ms)) continue;
    machine->is_preview_out_of_date = false;
    renew(name);
  }
}

void Previews::cancel() const {
  for (const auto& [name, machine] : around_.machines.records()) machine->cancel_preview();
}

}  // namespace kerf::server
