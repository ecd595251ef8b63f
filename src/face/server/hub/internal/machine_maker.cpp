#include "face/server/hub/internal/machine_maker.hpp"

#include <algorithm>

#include "face/server/hub/internal/console.hpp"
#include "face/server/store/program_name.hpp"
#include "face/server/store/samples.hpp"
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

Outcome<StoredMachine> first_machine(const FirstMachine& first) {
  auto machine = new_machine(std::string(first.name), std::string(first.kind));
  if (!machine) return machine;
  machine->program = LoadedProgram{std::string(first.program)};
  if (const auto* const dialect = machine::dialect_by_ending(machine->program->name))
    machine->program->dialect = std::string(dialect->name);
  return machine;
}

}  // namespace

// What cannot be read is told and left where it is.
Outcome<void> MachineMaker::start_all() {
  std::vector<std::string> troubles;
  const std::vector<StoredMachine> stored = around_.disk.store().read_all(troubles);
  for (const std::string& trouble : troubles) tell_console(trouble);
  for (const StoredMachine& machine : stored) start(machine);
  if (!stored.empty() || !troubles.empty()) return {};
  return make_first_machines();
}

// All of them or none: where one is there, the next start makes no others.
Outcome<void> MachineMaker::make_first_machines() {
  if (auto written = add_samples(); !written) return written;
  auto added = add_first_machines();
  if (!added) return tl::unexpected(added.error());
  for (const StoredMachine& machine : *added) start(machine);
  return {};
}

Outcome<void> MachineMaker::add_samples() {
  for (const Sample& sample : samples()) {
    const std::string name(sample.file);
    if (around_.library.path_of(name)) continue;
    if (auto written = around_.library.write(name, std::string(sample.text)); !written)
      return tl::unexpected(written.error());
  }
  return {};
}

Outcome<std::vector<StoredMachine>> MachineMaker::add_first_machines() {
  const MachineStore& store = around_.disk.store();
  std::vector<StoredMachine> added;
  for (const FirstMachine& first : first_machines()) {
    auto machine = first_machine(first);
    if (!machine) return tl::unexpected(machine.error());
    if (auto done = store.add(*machine); !done) {
      for (const StoredMachine& each : added) static_cast<void>(store.remove(each.name));
      return tl::unexpected(done.error());
    }
    added.push_back(std::move(*machine));
  }
  return added;
}

std::shared_ptr<Runner> MachineMaker::make_runner(const StoredMachine& stored) const {
  machine::LiveMachine::Settings settings;
  settings.library_folders = {around_.library.folder()};
  settings.machine_file = stored.toml;
  return std::make_shared<Runner>(stored.name, stored.definition, stored.memory, settings);
}

// Precondition: it is on the disk.
void MachineMaker::start(const StoredMachine& stored) {
  around_.disk.memories().know(stored.name, stored.memory);
  const auto runner = make_runner(stored);
  MachineThread& thread = around_.threads.choose();
  MachineRecord& machine =
      around_.machines.add(std::make_unique<MachineRecord>(stored, runner, thread));
  thread.add(runner);
  around_.programs.load_again(machine);
  around_.previews.start(machine, stored.definition, stored.memory);
}

void MachineMaker::create(const Request& request) {
  const std::string name = request.arguments().text("name");
  MachineTable& machines = around_.machines;
  if (auto checked = check_machine_name(name); !checked) return request.reply.no(checked.error());
  if (machines.find(name) != nullptr || machines.is_changing(name))
    return request.reply.no(base::Refusal::machine_exists, {name});
  if (machines.is_full())
    return request.reply.no(base::Refusal::machines_full, {std::to_string(limits::kMachines)});
  const auto machine = new_machine(name, request.arguments().text("definition"));
  if (!machine) return request.reply.no(machine.error());
  static_cast<void>(machines.begin_change(name));
  around_.disk.write(
      request.reply, [machine = *machine](const MachineStore& store) { return store.add(machine); },
      [this, machine = *machine, reply = request.reply](const Outcome<void>& added) {
        around_.machines.end_change(machine.name);
        if (added) created(machine, reply);
      });
}

void MachineMaker::created(const StoredMachine& machine, const Reply& reply) {
  start(machine);
  reply.yes();
  around_.machines.tell();
}

void MachineMaker::remove(const Request& request) {
  const std::string name = request.arguments().text("name");
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr) return request.reply.no(base::Refusal::no_machine, {name});
  for (const Client* const watcher : machine->watchers) {
    if (watcher != request.client.get())
      return request.reply.no(base::Refusal::machine_watched, {name, watcher->shown_name()});
  }
  if (!around_.machines.begin_change(name))
    return request.reply.no(base::Refusal::machine_leaving, {name});
  if (request.client->watched() == machine) around_.attendance.leave(*request.client);
  const auto take_out = [this, name](const MachineStore& store) {
    auto outcome = store.remove(name);
    if (outcome) around_.disk.memories().forget(name);
    return outcome;
  };
  around_.disk.write(request.reply, take_out,
                     [this, name, reply = request.reply](const Outcome<void>& outcome) {
                       around_.machines.end_change(name);
                       if (outcome) removed(name, reply);
                     });
}

void MachineMaker::removed(const std::string& name, const Reply& reply) {
  MachineRecord* const machine = around_.machines.find(name);
  machine->thread->remove(machine->runner);
  around_.machines.erase(name);
  reply.yes();
  around_.machines.tell();
}

}  // namespace kerf::server
