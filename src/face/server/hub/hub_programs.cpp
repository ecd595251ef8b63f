// What a machine of a hub has loaded, and the preview of it.
#include "face/server/hub/guarded.hpp"
#include "face/server/hub/hub.hpp"
#include "face/server/protocol/pattern_text.hpp"
#include "face/server/store/program_name.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {

using base::Outcome;

Outcome<base::ProgramText> Hub::text_of(const LoadedProgram& program,
                                        const machine::MachineDefinition& machine) const {
  if (program.text) return base::ProgramText::of(program.name, *program.text);
  auto path = library_->path_of(program.name);
  if (!path) return tl::unexpected(path.error());
  if (!is_pattern(program.name)) return base::ProgramText::at_path(*path);
  const auto file = base::SourceFile::open(*path);
  if (!file) return tl::unexpected(file.error());
  auto listing = listing_of(**file, program.name, machine.pattern.byte_order);
  if (!listing) return tl::unexpected(listing.error());
  return base::ProgramText::of(program.name, std::move(*listing));
}

void Hub::load(const Request& request) {
  const Arguments arguments = request.arguments();
  const bool from_library = arguments.has("program");
  if (from_library == arguments.has("text"))
    return request.reply.no("load: either `program` or `text` is needed");
  LoadedProgram program;
  program.name = arguments.text(from_library ? "program" : "name");
  if (!from_library) program.text = arguments.text("text");
  program.dialect = arguments.text("dialect");
  if (auto checked = check_program_name(program.name); !checked)
    return request.reply.no(checked.error());
  MachineRecord& machine = *request.machine;
  machine.thread->post(machine.runner, Pace::slow,
                       [this, program, name = machine.name, reply = request.reply,
                        thread = machine.thread, held = machine.runner](Runner& runner) {
                         const auto made = guarded([&]() -> Outcome<FoundProgram> {
                           auto ready = found(program, runner.machine().definition());
                           if (!ready) return ready;
                           auto possible =
                               runner.machine().can_load(ready->text, ready->program.dialect);
                           if (!possible) return tl::unexpected(possible.error());
                           return ready;
                         });
                         if (!made) return answer(reply, tl::unexpected(made.error()));
                         keep_and_load(name, *thread, held, *made, reply);
                       });
}

// Waits for the disk.
Outcome<Hub::FoundProgram> Hub::found(const LoadedProgram& program,
                                      const machine::MachineDefinition& machine) const {
  auto text = text_of(program, machine);
  if (!text) return tl::unexpected(text.error());
  FoundProgram ready{*text, program};
  if (const auto file = text->open(); file && program.dialect.empty())
    ready.program.dialect = machine::dialect_shown_by(**file);
  return ready;
}

// What can be refused has been asked; now the disk, then the machine has it.
void Hub::keep_and_load(const std::string& machine, MachineThread& thread,
                        const std::shared_ptr<Runner>& held, const FoundProgram& found,
                        const Reply& reply) {
  const auto load = [this, found, machine, reply](Runner& runner) {
    const auto done =
        guarded([&] { return runner.machine().load(found.text, found.program.dialect); });
    if (!done) return answer(reply, tl::unexpected(done.error()));
    to_sockets_([this, machine, program = found.program, reply, basis = basis_of(runner)] {
      loaded(machine, program, basis, reply);
    });
  };
  const auto keep = [this, load, found, machine, reply, &thread, held](Runner& /*runner*/) {
    const auto written = guarded([&] { return store_.write_program(machine, found.program); });
    if (!written) return answer(reply, tl::unexpected(written.error()));
    thread.lend(held, load);
  };
  thread.lend(held, *machine_disk_, keep);
}

Hub::PreviewBasis Hub::basis_of(Runner& runner) {
  machine::LiveMachine& machine = runner.machine();
  return {machine.definition_of_run(), machine.memory(), machine.snapshot()};
}

// The newest snapshot that has come by itself may be older than what the operator has set since.
void Hub::preview_from(MachineRecord& machine, const PreviewBasis& basis) {
  machine.snapshot = basis.snapshot;
  start_preview(machine, basis.definition, basis.memory);
}

void Hub::loaded(const std::string& name, const LoadedProgram& program, const PreviewBasis& basis,
                 const Reply& reply) {
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return reply.no(base::Refusal::machine_removed, {name});
  machine->program = program;
  preview_from(*machine, basis);
  tell_machines();
  reply.yes(Json{{"program", program.name}});
}

// The loaded program as cycle start would begin it now. A pattern begins at the zero of its motors,
// wherever they stand.
job::Job Hub::job_of(const MachineRecord& machine, const machine::MachineDefinition& definition,
                     const control::Memory& memory) const {
  const std::string& dialect = machine.program->dialect;
  job::Job job{.definition = dialect == machine::kPatternDialect
                                 ? machine::PatternMachine::at_zero(definition)
                                 : definition,
               .memory = memory,
               .settings = {.dialect = dialect, .library_folders = {library_->folder()}}};
  if (!machine.snapshot) return job;
  job.settings.signals.set_inputs(machine.snapshot->inputs);
  job.settings.block_skip = machine.snapshot->panel.skip_levels;
  job.settings.optional_stop = machine.snapshot->panel[machine::Switch::optional_stop];
  return job;
}

void Hub::start_preview(MachineRecord& machine, const machine::MachineDefinition& definition,
                        const control::Memory& memory) {
  thread_.here();
  machine.cancel_preview();
  machine.preview.reset();
  machine.preview_began_ms = clock_.now_ms();
  if (!machine.program) return;
  PreviewOrder order{.job = job_of(machine, definition, memory),
                     .program = [this, program = *machine.program,
                                 definition] { return text_of(program, definition); },
                     .run = ++machine.preview_run};
  const auto preview = std::make_shared<Preview>(
      std::move(order), std::make_shared<ChunkStore>(settings_.data, chunk_budget_));
  machine.preview = preview;
  machine.path = PreviewState{machine.preview_run, false, {}, {}, nullptr};
  for (Client* const watcher : machine.watchers) {
    watcher->send(machine.path_event());
    watcher->begin_chunks(preview->chunks());
  }
  machine.touch();
  previews_->post([this, preview, name = machine.name] {
    const auto tell_state = [&](const PreviewState& state) {
      to_sockets_([this, name, preview, state] { previewed(name, preview, state); });
    };
    try {
      preview->run(tell_state);
    } catch (const std::exception& fault) {
      tell(name + ": the preview: fault of Kerf itself: " + fault.what());
    }
  });
}

void Hub::renew_preview(MachineRecord& machine) {
  machine.thread->post(machine.runner, Pace::quick, [this, name = machine.name](Runner& runner) {
    to_sockets_([this, name, basis = basis_of(runner)] {
      if (MachineRecord* const found = find(name)) preview_from(*found, basis);
    });
  });
}

void Hub::previewed(const std::string& name, const std::shared_ptr<Preview>& preview,
                    const PreviewState& state) {
  thread_.here();
  MachineRecord* const machine = find(name);
  if (machine == nullptr || machine->preview != preview) return;  // of a program before this one
  machine->path = state;
  if (Json& error = machine->path->error; error.is_object())
    error["message"] = without_folder(error["message"].get<std::string>());
  for (Client* const watcher : machine->watchers) {
    watcher->send(machine->path_event());
    watcher->wake();
  }
  if (state.done) machine->touch();
}

}  // namespace kerf::server
