// Who watches a machine of a hub, and who operates it.
#include <algorithm>

#include "server/hub.hpp"
#include "server/state_json.hpp"

namespace kerf::server {

void Hub::watch(const Request& request) {
  const std::string name = request.arguments().text("machine");
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return request.reply.no("there is no machine " + name);
  if (under_way_.contains(name)) return request.reply.no(name + " is being removed");
  Client& client = *request.client;
  if (client.watched() != machine) leave_machine(client);
  std::erase(machine->watchers, &client);
  machine->watchers.push_back(&client);
  request.reply.yes({{"client", client.name()},
                     {"definition", definition_json(machine->definition)},
                     {"settings", machine->toml},
                     {"breakpoints", machine->breakpoints}});
  client.watch(machine);
  if (machine->path) client.send(machine->path_event());
  if (machine->preview) client.begin_chunks(machine->preview->chunks());
  machine->touch();
  tell_machines();
}

void Hub::leave_machine(Client& client) {
  MachineRecord* const machine = client.watched();
  if (machine == nullptr) return;
  std::erase(machine->watchers, &client);
  client.watch(nullptr);
  if (machine->op == &client) set_operator(*machine, nullptr);
  machine->touch();
  tell_machines();
}

// Who lets go of the panel lets go of its jog keys.
void Hub::set_operator(MachineRecord& machine, Client* client) {
  if (machine.op != nullptr && machine.op != client)
    machine.thread->post(machine.runner, Pace::quick,
                         [](Runner& runner) { static_cast<void>(runner.machine().jog_stop()); });
  machine.op = client;
  machine.touch();
}

void Hub::operate(const Request& request) {
  MachineRecord& machine = *request.machine;
  Client* const client = request.client.get();
  const Arguments arguments = request.arguments();
  const bool mine = machine.op == client;
  if (arguments.has("hand_to")) {
    const std::string to = arguments.text("hand_to");
    if (!mine) return request.reply.no("only who operates " + machine.name + " can hand it over");
    const auto found = std::find_if(machine.watchers.begin(), machine.watchers.end(),
                                    [&](const Client* each) { return each->name() == to; });
    if (found == machine.watchers.end())
      return request.reply.no("no client " + to + " watches " + machine.name);
    set_operator(machine, *found);
  } else if (arguments.flag("take")) {
    if (machine.op != nullptr && !mine)
      return request.reply.no(machine.name + " is operated by " + machine.op->name() +
                              ", who can hand it over");
    set_operator(machine, client);
  } else if (mine) {
    set_operator(machine, nullptr);
  }
  request.reply.yes();
  tell_machines();
}

}  // namespace kerf::server
