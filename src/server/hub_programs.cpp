// What a machine of a hub has loaded, and the preview of it.
#include "machine/language.hpp"
#include "server/guarded.hpp"
#include "server/hub.hpp"
#include "server/program_name.hpp"
#include "server/shown_dialect.hpp"

namespace kerf::server {

using base::Outcome;

Outcome<machine::ProgramText> Hub::text_of(const LoadedProgram& program) const {
  if (program.text) return machine::ProgramText::of(program.name, *program.text);
  auto path = library_->path_of(program.name);
  if (!path) return tl::unexpected(path.error());
  return machine::ProgramText::at_path(*path);
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
  if (const std::string why = not_for_the_panel(program.name); !why.empty())
    return request.reply.no(why);
  const auto text = text_of(program);
  if (!text) return request.reply.no(text.error());
  if (const auto file = text->open(); file && program.dialect.empty())
    program.dialect = dialect_shown_by(**file);
  keep_and_load(*request.machine, *text, program, request.reply);
}

// What can be refused is asked first, then the disk, then the machine has it.
void Hub::keep_and_load(MachineRecord& machine, const machine::ProgramText& text,
                        const LoadedProgram& program, const Reply& reply) {
  const auto load = [this, text, program, name = machine.name, reply](Runner& runner) {
    const auto done = guarded([&] { return runner.machine().load(text, program.dialect); });
    to_sockets_([this, name, program, reply, done,
                 definition = runner.machine().definition_of_run(),
                 memory = runner.machine().memory()] {
      done ? loaded(name, program, definition, memory, reply) : reply.no(done.error().message);
    });
  };
  const auto keep = [this, load, program, name = machine.name, reply, thread = machine.thread,
                     held = machine.runner](Runner& /*runner*/) {
    const auto written = guarded([&] { return store_.write_program(name, program); });
    if (written) return thread->lend(held, load);
    to_sockets_([reply, written] { reply.no(written.error().message); });
  };
  machine.thread->post(machine.runner, Pace::slow,
                       [this, keep, text, program, reply, thread = machine.thread,
                        held = machine.runner](Runner& runner) {
                         const auto possible = guarded(
                             [&] { return runner.machine().can_load(text, program.dialect); });
                         if (possible) return thread->lend(held, *machine_disk_, keep);
                         to_sockets_([reply, possible] { reply.no(possible.error().message); });
                       });
}

void Hub::loaded(const std::string& name, const LoadedProgram& program,
                 const machine::MachineDefinition& definition, const control::Memory& memory,
                 const Reply& reply) {
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return reply.no("the machine " + name + " has been removed");
  machine->program = program;
  start_preview(*machine, definition, memory);
  tell_machines();
  reply.yes(Json{{"program", program.name}});
}

void Hub::start_preview(MachineRecord& machine, const machine::MachineDefinition& definition,
                        const control::Memory& memory) {
  thread_.here();
  machine.cancel_preview();
  machine.preview.reset();
  if (!machine.program) return;
  const auto text = text_of(*machine.program);
  auto chunks = ChunkStore::create(settings_.data, chunk_budget_);
  if (!text || !chunks) return;
  PreviewOrder order{definition, memory, *text, machine.program->dialect, library_->folder()};
  order.run = ++machine.preview_run;
  if (machine.snapshot) {
    order.skip_levels = machine.snapshot->panel.skip_levels;
    order.inputs = machine.snapshot->inputs;
    order.optional_stop = machine.snapshot->panel[machine::Switch::optional_stop];
  }
  const auto preview = std::make_shared<Preview>(std::move(order), std::move(*chunks));
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
    to_sockets_([this, name, definition = runner.machine().definition_of_run(),
                 memory = runner.machine().memory()] {
      if (MachineRecord* const found = find(name)) start_preview(*found, definition, memory);
    });
  });
}

void Hub::previewed(const std::string& name, const std::shared_ptr<Preview>& preview,
                    const PreviewState& state) {
  thread_.here();
  MachineRecord* const machine = find(name);
  if (machine == nullptr || machine->preview != preview) return;  // of a program before this one
  machine->path = state;
  for (Client* const watcher : machine->watchers) {
    watcher->send(machine->path_event());
    watcher->wake();
  }
  if (state.done) machine->touch();
}

}  // namespace kerf::server
