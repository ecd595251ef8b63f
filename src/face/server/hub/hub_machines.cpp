// Machines of a hub: how they are made, begun, replaced and removed.
#include <algorithm>

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/hub.hpp"
#include "face/server/protocol/state_json.hpp"
#include "face/server/store/program_name.hpp"
#include "face/server/store/samples.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/registry.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;

const machine::BuiltinMachine* find_builtin(std::string_view name) {
  const auto& all = machine::builtin_machines();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Outcome<StoredMachine> new_machine(const std::string& name, const std::string& kind) {
  const machine::BuiltinMachine* const builtin = find_builtin(kind);
  if (builtin == nullptr)
    return tl::unexpected(base::refuse(base::Refusal::no_builtin, {output::printable(kind)}));
  StoredMachine machine;
  machine.name = name;
  machine.kind = kind;
  machine.toml = std::string(builtin->toml);
  auto definition = machine::MachineDefinition::parse(builtin->toml, kind);
  if (!definition) return tl::unexpected(definition.error());
  machine.definition = std::move(*definition);
  machine.memory = control::Memory(machine.definition.parameters.n_offsets);
  return machine;
}

}  // namespace

// All of them or none: where one is there, the next start makes no others.
Outcome<void> Hub::make_first_machines() {
  auto added = add_first_machines();
  if (!added) return tl::unexpected(added.error());
  for (const StoredMachine& machine : *added) start(machine);
  return {};
}

Outcome<std::vector<StoredMachine>> Hub::add_first_machines() {
  for (const Sample& sample : samples()) {
    const std::string name(sample.file);
    if (library_->path_of(name)) continue;
    if (auto written = library_->write(name, std::string(sample.text)); !written)
      return tl::unexpected(written.error());
  }
  std::vector<StoredMachine> added;
  for (const FirstMachine& first : first_machines()) {
    auto machine = new_machine(std::string(first.name), std::string(first.kind));
    if (!machine) return tl::unexpected(machine.error());
    machine->program = LoadedProgram{std::string(first.program)};
    if (const auto* const dialect = machine::dialect_by_ending(machine->program->name))
      machine->program->dialect = std::string(dialect->name);
    if (auto done = store_.add(*machine); !done) {
      for (const StoredMachine& each : added) static_cast<void>(store_.remove(each.name));
      return tl::unexpected(done.error());
    }
    added.push_back(std::move(*machine));
  }
  return added;
}

std::shared_ptr<Runner> Hub::make_runner(const StoredMachine& stored) const {
  machine::LiveMachine::Settings settings;
  settings.library_folders = {library_->folder()};
  return std::make_shared<Runner>(stored.name, stored.definition, stored.memory, settings);
}

// Precondition: it is on the disk.
void Hub::start(const StoredMachine& stored) {
  keeper_.know(stored.name, stored.memory);
  const auto runner = make_runner(stored);
  MachineThread& thread = threads_->choose();
  auto record = std::make_unique<MachineRecord>(stored, runner, thread);
  MachineRecord& machine = *record;
  machines_[stored.name] = std::move(record);
  thread.add(runner);
  load_into(machine);
  start_preview(machine, stored.definition, stored.memory);
}

// What cannot be loaded any more is told when somebody loads it again.
void Hub::load_into(MachineRecord& machine) {
  if (!machine.program) return;
  machine.thread->post(
      machine.runner, Pace::slow,
      [this, program = *machine.program, breakpoints = machine.breakpoint_list](Runner& runner) {
        const auto text = text_of(program, runner.machine().definition());
        if (!text) return tell(runner.name() + ": " + text.error().message);
        static_cast<void>(runner.machine().load(*text, program.dialect));
        static_cast<void>(runner.machine().set_breakpoints(breakpoints));
      });
}

void Hub::create(const Request& request) {
  const std::string name = request.arguments().text("name");
  if (auto checked = check_machine_name(name); !checked) return request.reply.no(checked.error());
  if (find(name) != nullptr || under_way_.contains(name))
    return request.reply.no(base::Refusal::machine_exists, {name});
  if (machines_.size() + under_way_.size() >= limits::kMachines)
    return request.reply.no(base::Refusal::machines_full, {std::to_string(limits::kMachines)});
  auto machine = new_machine(name, request.arguments().text("definition"));
  if (!machine) return request.reply.no(machine.error());
  under_way_.insert(name);
  const auto done = [this, name, machine = *machine, reply = request.reply](Outcome<void> added) {
    under_way_.erase(name);
    if (!added) return;
    start(machine);
    reply.yes();
    tell_machines();
  };
  write(
      request.reply, [machine = *machine](const MachineStore& store) { return store.add(machine); },
      done);
}

void Hub::remove(const Request& request) {
  const std::string name = request.arguments().text("name");
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return request.reply.no(base::Refusal::no_machine, {name});
  for (const Client* const watcher : machine->watchers) {
    if (watcher != request.client.get())
      return request.reply.no(base::Refusal::machine_watched, {name, watcher->shown_name()});
  }
  if (!under_way_.insert(name).second)
    return request.reply.no(base::Refusal::machine_leaving, {name});
  if (request.client->watched() == machine) leave_machine(*request.client);
  write(
      request.reply,
      [this, name](const MachineStore& store) {
        auto removed = store.remove(name);
        if (removed) keeper_.forget(name);
        return removed;
      },
      [this, name, reply = request.reply](Outcome<void> removed) {
        under_way_.erase(name);
        if (!removed) return;
        take_out(name);
        reply.yes();
        tell_machines();
      });
}

void Hub::take_out(const std::string& name) {
  MachineRecord* const machine = find(name);
  machine->thread->remove(machine->runner);
  machines_.erase(name);
}

// The machine file

void Hub::replace_definition(const Request& request) {
  MachineRecord& machine = *request.machine;
  StoredMachine stored{machine.name, machine.kind, request.arguments().text("toml"), {}};
  auto definition = machine::MachineDefinition::parse(stored.toml, machine.name + ".toml");
  if (!definition) return request.reply.no(definition.error().message);
  if (auto known = machine::check_dialect(*definition, definition->dialect); !known)
    return request.reply.no(known.error().message);
  stored.definition = std::move(*definition);
  const auto replace = [this, stored, reply = request.reply](Runner& runner) {
    const auto kept = guarded([&] { return keep_definition(stored, runner); });
    to_sockets_([this, stored, reply, kept, memory = runner.machine().memory()]() mutable {
      if (!kept) return reply.no(kept.error().message);
      stored.memory = std::move(memory);
      put_definition(stored, reply);
    });
  };
  machine.thread->post(machine.runner, Pace::quick,
                       [this, replace, reply = request.reply, thread = machine.thread,
                        held = machine.runner](Runner& runner) {
                         const machine::Status status = runner.machine().snapshot()->status;
                         if (status != machine::Status::running && status != machine::Status::held)
                           return thread->lend(held, *machine_disk_, replace);
                         to_sockets_([reply] { reply.no(base::Refusal::settings_moving); });
                       });
}

// The machine is made anew with the memory that it had. One of fewer tools goes to the disk first:
// what is there fits the machine file at every moment.
Outcome<void> Hub::keep_definition(const StoredMachine& stored, Runner& runner) {
  control::Memory memory = runner.machine().memory();
  const std::size_t tools = control::Memory(stored.definition.parameters.n_offsets).tools.size();
  const bool fewer = tools < memory.tools.size();
  memory.tools.resize(tools);
  if (fewer) {
    if (auto written = keeper_.write(stored.name, memory); !written) return written;
  }
  if (auto written = store_.write_definition(stored.name, stored.kind, stored.toml); !written)
    return written;
  runner.replace_definition(stored.definition, std::move(memory));
  return {};
}

void Hub::put_definition(const StoredMachine& stored, const Reply& reply) {
  MachineRecord* const machine = find(stored.name);
  if (machine == nullptr) return reply.no(base::Refusal::machine_removed, {stored.name});
  machine->definition = stored.definition;
  machine->toml = stored.toml;
  start_preview(*machine, stored.definition, stored.memory);
  const Json event = {{"event", "definition"},
                      {"machine", stored.name},
                      {"definition", definition_json(stored.definition)},
                      {"settings", stored.toml}};
  for (Client* const watcher : machine->watchers) watcher->send(event);
  reply.yes();
}

}  // namespace kerf::server
