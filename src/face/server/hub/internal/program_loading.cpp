#include "face/server/hub/internal/program_loading.hpp"

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/internal/console.hpp"
#include "face/server/hub/internal/program_source.hpp"
#include "face/server/store/program_name.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;

// What a command names. Failure (usage).
Outcome<LoadedProgram> program_of(const Arguments& arguments) {
  const bool from_library = arguments.has("program");
  if (from_library == arguments.has("text"))
    return tl::unexpected(
        Failure{Failure::Kind::usage, "load: either `program` or `text` is needed"});
  LoadedProgram program;
  program.name = arguments.text(from_library ? "program" : "name");
  if (!from_library) program.text = arguments.text("text");
  program.dialect = arguments.text("dialect");
  if (auto checked = check_program_name(program.name); !checked)
    return tl::unexpected(checked.error());
  return program;
}

}  // namespace

void ProgramLoading::load(const Request& request) {
  const auto program = program_of(request.arguments());
  if (!program) return request.reply.no(program.error());
  MachineRecord& machine = *request.machine;
  machine.thread->post(
      machine.runner, Pace::slow,
      [this, program = *program,
       loading = Loading{machine.name, *machine.thread, machine.runner, request.reply}](
          Runner& runner) { find(loading, program, runner); });
}

void ProgramLoading::find(const Loading& loading, const LoadedProgram& program, Runner& runner) {
  const auto ready = guarded([&] { return found(program, runner); });
  if (!ready) return around_.answers.answer(loading.reply, tl::unexpected(ready.error()));
  loading.thread.lend(
      loading.held, around_.disk.worker(),
      [this, loading, found = *ready](Runner& /*runner*/) { keep(loading, found); });
}

void ProgramLoading::load_made(MachineRecord& machine, const Reply& reply, const Made& made) {
  Loading loading{machine.name, *machine.thread, machine.runner, reply};
  loading.more = made.more;
  machine.thread->post(machine.runner, Pace::slow, [this, made, loading](Runner& runner) {
    const auto possible = guarded([&] {
      return runner.machine().can_load({base::ProgramText::of(made.name, made.text), made.dialect});
    });
    if (!possible) return around_.answers.answer(loading.reply, tl::unexpected(possible.error()));
    loading.thread.lend(loading.held, around_.library_disk,
                        [this, loading, made](Runner& /*runner*/) { write(loading, made); });
  });
}

// On the thread of the library's disk.
void ProgramLoading::write(const Loading& loading, const Made& made) {
  auto written = guarded([&] { return made.write(around_.library); });
  if (!written) return around_.answers.answer(loading.reply, tl::unexpected(written.error()));
  Loading next = loading;
  next.answer = std::move(*written);
  const LoadedProgram program{.name = made.name, .dialect = made.dialect};
  const Found found{base::ProgramText::at_path(around_.library.folder() + "/" + made.name),
                    program};
  loading.thread.lend(loading.held, around_.disk.worker(),
                      [this, next, found](Runner& /*runner*/) { keep(next, found); });
}

// Waits for the disk, and asks all that can be refused.
Outcome<ProgramLoading::Found> ProgramLoading::found(const LoadedProgram& program,
                                                     Runner& runner) const {
  auto text = text_of(around_.library, program, runner.machine().definition());
  if (!text) return tl::unexpected(text.error());
  Found ready{*text, program};
  if (const auto file = text->open(); file && program.dialect.empty())
    ready.program.dialect = machine::dialect_shown_by(**file);
  auto possible = runner.machine().can_load({ready.text, ready.program.dialect});
  if (!possible) return tl::unexpected(possible.error());
  return ready;
}

// On the thread of the disk.
void ProgramLoading::keep(const Loading& loading, const Found& found) {
  const auto written =
      guarded([&] { return around_.disk.store().write_program(loading.machine, found.program); });
  if (!written) return around_.answers.answer(loading.reply, tl::unexpected(written.error()));
  loading.thread.lend(loading.held,
                      [this, loading, found](Runner& runner) { give(loading, found, runner); });
}

void ProgramLoading::give(const Loading& loading, const Found& found, Runner& runner) {
  const auto done = guarded([&] {
    return runner.machine().perform(machine::Load{found.text, found.program.dialect});
  });
  if (!done) return around_.answers.answer(loading.reply, tl::unexpected(done.error()));
  around_.answers.to_sockets(
      [this, loading, program = found.program, basis = PreviewBasis::of(runner)] {
        loaded(loading, program, basis);
      });
}

void ProgramLoading::loaded(const Loading& loading, const LoadedProgram& program,
                            const PreviewBasis& basis) {
  MachineRecord* const machine = around_.machines.find(loading.machine);
  if (machine == nullptr)
    return loading.reply.no(base::Refusal::machine_removed, {loading.machine});
  machine->program = program;
  around_.previews.start(*machine, basis);
  around_.machines.tell();
  Json answer = loading.answer;
  answer.update(loading.more ? loading.more(*machine) : Json{{"program", program.name}});
  loading.reply.yes(std::move(answer));
}

void ProgramLoading::load_again(MachineRecord& machine) {
  if (!machine.program) return;
  machine.thread->post(
      machine.runner, Pace::slow,
      [this, program = *machine.program, breakpoints = machine.breakpoint_list](Runner& runner) {
        const auto text = text_of(around_.library, program, runner.machine().definition());
        if (!text) return tell_console(runner.name() + ": " + text.error().message);
        static_cast<void>(runner.machine().perform(machine::Load{*text, program.dialect}));
        static_cast<void>(runner.machine().perform(machine::SetBreakpoints{breakpoints}));
      });
}

}  // namespace kerf::server
