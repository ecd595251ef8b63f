#include "face/server/hub/internal/machine_files.hpp"

#include "face/server/hub/guarded.hpp"
#include "face/server/protocol/state_json.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

Outcome<StoredMachine> with_file(const MachineRecord& machine, const std::string& toml) {
  auto definition = machine::MachineDefinition::parse(toml, machine.name + ".toml");
  if (!definition) return tl::unexpected(definition.error());
  if (auto known = machine::check_dialect(*definition, definition->dialect); !known)
    return tl::unexpected(known.error());
  return StoredMachine{machine.name, machine.kind, toml, std::move(*definition)};
}

bool is_at_rest(const machine::Snapshot& snapshot) {
  return snapshot.status != machine::Status::running && snapshot.status != machine::Status::held;
}

}  // namespace

void MachineFiles::replace(const Request& request) {
  MachineRecord& machine = *request.machine;
  const auto stored = with_file(machine, request.arguments().text("toml"));
  if (!stored) return request.reply.no(stored.error().message);
  machine.thread->post(
      machine.runner, Pace::quick,
      [this, stored = *stored, reply = request.reply, thread = machine.thread,
       held = machine.runner](Runner& runner) {
        if (!is_at_rest(*runner.machine().snapshot()))
          return answers_.to_sockets([reply] { reply.no(base::Refusal::settings_moving); });
        thread->lend(held, disk_.worker(), [this, stored, reply](Runner& at_disk) {
          replace_at_rest(stored, reply, at_disk);
        });
      });
}

void MachineFiles::replace_at_rest(const StoredMachine& stored, const Reply& reply,
                                   Runner& runner) {
  const auto kept = guarded([&] { return keep(stored, runner); });
  answers_.to_sockets([this, stored, reply, kept, memory = runner.machine().memory()] {
    if (!kept) return reply.no(kept.error().message);
    put(stored, memory, reply);
  });
}

// The machine is made anew with the memory that it had. One of fewer tools goes to the disk first:
// what is there fits the machine file at every moment.
Outcome<void> MachineFiles::keep(const StoredMachine& stored, Runner& runner) {
  control::Memory memory = runner.machine().memory();
  const std::size_t tools = control::Memory(stored.definition.parameters.n_offsets).tools.size();
  const bool fewer = tools < memory.tools.size();
  memory.tools.resize(tools);
  if (fewer) {
    if (auto written = disk_.memories().write(stored.name, memory); !written) return written;
  }
  auto written = disk_.store().write_definition(stored.name, stored.kind, stored.toml);
  if (!written) return written;
  runner.replace_definition(stored.definition, stored.toml, std::move(memory));
  return {};
}

void MachineFiles::put(const StoredMachine& stored, const control::Memory& memory,
                       const Reply& reply) {
  MachineRecord* const machine = machines_.find(stored.name);
  if (machine == nullptr) return reply.no(base::Refusal::machine_removed, {stored.name});
  machine->definition = stored.definition;
  machine->toml = stored.toml;
  previews_.start(*machine, stored.definition, memory);
  const Json event = {{"event", "definition"},
                      {"machine", stored.name},
                      {"definition", definition_json(stored.definition)},
                      {"settings", stored.toml}};
  for (Client* const watcher : machine->watchers) watcher->send(event);
  reply.yes();
}

}  // namespace kerf::server
