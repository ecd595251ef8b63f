// Machines of a hub: how they are made, begun, replaced and removed.
#include <algorithm>

#include "machine/language.hpp"
#include "output/diagnostic_text.hpp"
#include "server/hub.hpp"
#include "server/program_name.hpp"
#include "server/samples.hpp"
#include "server/state_json.hpp"

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
    return tl::unexpected(
        Failure{Failure::Kind::usage, "there is no built-in machine " + output::printable(kind)});
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

void Hub::make_first_machines() {
  for (const Sample& sample : samples()) {
    const std::string name(sample.file);
    if (library_->path_of(name)) continue;
    if (auto written = library_->write(name, std::string(sample.text)); !written)
      tell(written.error().message);
  }
  for (const FirstMachine& first : first_machines()) {
    auto machine = new_machine(std::string(first.name), std::string(first.kind));
    if (!machine) {
      tell(machine.error().message);
      continue;
    }
    machine->program = LoadedProgram{std::string(first.program)};
    if (const auto language = machine::language_by_ending(machine->program->name))
      machine->program->dialect = std::string(language->dialect);
    if (auto added = store_.add(*machine); !added) tell(added.error().message);
    start(*machine);
  }
}

std::shared_ptr<Runner> Hub::make_runner(const StoredMachine& stored) const {
  machine::LiveMachine::Settings settings;
  settings.library_folders = {library_->folder()};
  return std::make_shared<Runner>(stored.name, stored.definition, stored.memory, settings);
}

void Hub::start(const StoredMachine& stored) {
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
  const auto text = text_of(*machine.program);
  if (!text) return tell(machine.name + ": " + text.error().message);
  machine.thread->post(machine.runner, Pace::slow,
                       [text = *text, dialect = machine.program->dialect,
                        breakpoints = machine.breakpoint_list](Runner& runner) {
                         static_cast<void>(runner.machine().load(text, dialect));
                         static_cast<void>(runner.machine().set_breakpoints(breakpoints));
                       });
}

void Hub::create(const Request& request) {
  const std::string name = request.arguments().text("name");
  if (auto checked = check_machine_name(name); !checked)
    return request.reply.no(checked.error().message);
  if (find(name) != nullptr) return request.reply.no("there is a machine " + name + " already");
  if (machines_.size() >= limits::kMachines)
    return request.reply.no("this server has " + std::to_string(limits::kMachines) +
                            " machines, and takes no more");
  auto machine = new_machine(name, request.arguments().text("definition"));
  if (!machine) return request.reply.no(machine.error().message);
  start(*machine);
  write(request.reply, Json::object(),
        [machine = *machine](const MachineStore& store) { return store.add(machine); });
  tell_machines();
}

void Hub::remove(const Request& request) {
  const std::string name = request.arguments().text("name");
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return request.reply.no("there is no machine " + name);
  for (const Client* const watcher : machine->watchers) {
    if (watcher != request.client.get())
      return request.reply.no(name + " cannot be removed while " + watcher->name() + " watches it");
  }
  if (request.client->watched() == machine) leave_machine(*request.client);
  machine->thread->remove(machine->runner);
  machines_.erase(name);
  write(request.reply, Json::object(),
        [name](const MachineStore& store) { return store.remove(name); });
  tell_machines();
}

// The machine file

void Hub::replace_definition(const Request& request) {
  MachineRecord& machine = *request.machine;
  const std::string toml = request.arguments().text("toml");
  auto definition = machine::MachineDefinition::parse(toml, machine.name + ".toml");
  if (!definition) return request.reply.no(definition.error().message);
  machine.thread->post(
      machine.runner, Pace::quick,
      [this, reply = request.reply, name = machine.name, toml,
       definition = std::move(*definition)](Runner& runner) {
        const machine::Status status = runner.machine().snapshot()->status;
        const bool busy = status == machine::Status::running || status == machine::Status::held;
        to_sockets_([this, reply, name, toml, definition, busy,
                     memory = runner.machine().memory()]() mutable {
          if (busy) return reply.no("the machine file can be changed only while nothing moves");
          put_definition(name, toml, definition, std::move(memory), reply);
        });
      });
}

// The machine is made anew with the memory that it had.
void Hub::put_definition(const std::string& name, const std::string& toml,
                         const machine::MachineDefinition& definition, control::Memory memory,
                         const Reply& reply) {
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return reply.no("the machine " + name + " has been removed");
  memory.tools.resize(control::Memory(definition.parameters.n_offsets).tools.size());
  StoredMachine stored{name, machine->kind, toml, definition, std::move(memory), machine->program};
  machine->thread->remove(machine->runner);
  machine->runner = make_runner(stored);
  machine->definition = definition;
  machine->toml = toml;
  machine->thread->add(machine->runner);
  load_into(*machine);
  start_preview(*machine, stored.definition, stored.memory);
  const Json event = {{"event", "definition"},
                      {"machine", name},
                      {"definition", definition_json(definition)},
                      {"settings", toml}};
  for (Client* const watcher : machine->watchers) watcher->send(event);
  write(reply, Json::object(), [stored](const MachineStore& store) {
    return store.write_definition(stored.name, stored.kind, stored.toml);
  });
}

}  // namespace kerf::server
