#include "face/server/hub/internal/attendance.hpp"

#include <algorithm>

#include "face/server/protocol/state_json.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {

void Attendance::watch(const Request& request) {
  const std::string name = request.arguments().text("machine");
  MachineRecord* const machine = machines_.find(name);
  if (machine == nullptr) return request.reply.no(base::Refusal::no_machine, {name});
  if (machines_.is_changing(name)) return request.reply.no(base::Refusal::machine_leaving, {name});
  Client& client = *request.client;
  if (client.watched() != machine) leave(client);
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
  machines_.tell();
}

void Attendance::leave(Client& client) {
  MachineRecord* const machine = client.watched();
  if (machine == nullptr) return;
  std::erase(machine->watchers, &client);
  client.watch(nullptr);
  if (machine->request && machine->request->client == &client) machine->request.reset();
  if (machine->op == &client)
    set_operator(*machine, machine->request ? machine->request->client : nullptr);
  machine->touch();
  machines_.tell();
}

// Who lets go of the panel lets go of its jog keys.
void Attendance::set_operator(MachineRecord& machine, Client* client) {
  if (machine.op != nullptr && machine.op != client) end_jog(machine);
  machine.op = client;
  machine.request.reset();
  machine.touch();
}

void Attendance::end_jog(MachineRecord& machine) {
  machine.thread->post(machine.runner, Pace::quick, [](Runner& runner) {
    static_cast<void>(runner.machine().perform(machine::JogStop{}));
  });
}

void Attendance::tick() {
  const double now_ms = clock_.now_ms();
  for (const auto& [name, machine] : machines_.records()) {
    if (machine->op != nullptr && machine->op->falls_silent(now_ms)) end_jog(*machine);
    if (!machine->request || now_ms < machine->request->until_ms) continue;
    set_operator(*machine, machine->request->client);
    machines_.tell();
  }
}

void Attendance::ping(const Request& request) {
  request.client->sends_pings = true;
  request.reply.yes({{"time_ms", clock_.now_ms()}});
}

void Attendance::introduce(const Request& request) {
  request.client->person = output::printable(request.arguments().text("name"));
  request.reply.yes();
  if (request.machine != nullptr) request.machine->touch();
}

void Attendance::request_operation(const Request& request) {
  MachineRecord& machine = *request.machine;
  Client* const client = request.client.get();
  const bool mine = machine.request && machine.request->client == client;
  if (!request.arguments().flag("ask")) {
    if (mine) machine.request.reset();
  } else if (machine.op == nullptr || machine.op == client) {
    set_operator(machine, client);
    machines_.tell();
  } else if (machine.request && !mine) {
    return request.reply.no(base::Refusal::asked_already,
                            {machine.request->client->shown_name(), machine.name});
  } else if (!mine) {
    machine.request = {client, clock_.now_ms() + 1000.0 * limits::kRequestSeconds};
  }
  machine.touch();
  request.reply.yes();
}

void Attendance::answer_request(const Request& request) {
  MachineRecord& machine = *request.machine;
  if (!machine.request) return request.reply.no(base::Refusal::nobody_asks, {machine.name});
  Client* const client = machine.request->client;
  if (request.arguments().flag("grant")) {
    set_operator(machine, client);
    machines_.tell();
  } else {
    machine.request.reset();
    client->send({{"event", "request-refused"}, {"machine", machine.name}});
    machine.touch();
  }
  request.reply.yes();
}

void Attendance::operate(const Request& request) {
  MachineRecord& machine = *request.machine;
  Client* const client = request.client.get();
  const Arguments arguments = request.arguments();
  const bool mine = machine.op == client;
  if (arguments.has("hand_to")) {
    const std::string to = arguments.text("hand_to");
    if (!mine) return request.reply.no(base::Refusal::hands_over_only, {machine.name});
    const auto found = std::find_if(machine.watchers.begin(), machine.watchers.end(),
                                    [&](const Client* each) { return each->name() == to; });
    if (found == machine.watchers.end())
      return request.reply.no(base::Refusal::no_client, {to, machine.name});
    set_operator(machine, *found);
  } else if (arguments.flag("take")) {
    if (machine.op != nullptr && !mine)
      return request.reply.no(base::Refusal::hands_over, {machine.name, machine.op->shown_name()});
    set_operator(machine, client);
  } else if (mine) {
    set_operator(machine, nullptr);
  }
  request.reply.yes();
  machines_.tell();
}

}  // namespace kerf::server
