#include "server/hub.hpp"

#include <cstdio>

#include "output/diagnostic_text.hpp"
#include "server/guarded.hpp"
#include "server/handlers.hpp"

namespace kerf::server {

using base::Outcome;

// Start and end

Hub::Hub(Settings settings, ToSockets to_sockets, std::unique_ptr<Library> library,
         MachineStore store, FolderLock lock)
    : settings_(std::move(settings)),
      to_sockets_(std::move(to_sockets)),
      lock_(std::move(lock)),
      library_(std::move(library)),
      store_(std::move(store)),
      disk_(std::make_unique<Worker>()),
      saver_(store_, *disk_, [this](const std::string& sentence) { tell(sentence); }),
      aside_(std::make_unique<Worker>(2, Worker::Priority::background)),
      previews_(std::make_unique<Worker>(2, Worker::Priority::background)) {
  threads_ = std::make_unique<MachineThreads>(
      settings_.threads, [this](std::vector<Publication> publications) {
        for (const Publication& each : publications) {
          if (each.memory) saver_.save(each.machine, each.memory);
        }
        to_sockets_([this, publications = std::move(publications)] { published(publications); });
      });
}

// Machines stop, then what their memory holds is written, then the threads end.
Hub::~Hub() {
  for (const auto& [name, machine] : machines_) machine->cancel_preview();
  threads_.reset();
  previews_.reset();
  aside_.reset();
  for (const auto& [name, machine] : machines_) {
    if (auto memory = machine->runner->memory_not_told()) saver_.save(name, std::move(memory));
  }
  disk_.reset();
}

Outcome<std::unique_ptr<Hub>> Hub::open(const Settings& settings, ToSockets to_sockets) {
  auto lock = FolderLock::take(settings.data);
  if (!lock) return tl::unexpected(lock.error());
  auto library = Library::open(settings.data + "/library", settings.data + "/revisions.sqlite");
  if (!library) return tl::unexpected(library.error());
  auto store = MachineStore::open(settings.data + "/machines");
  if (!store) return tl::unexpected(store.error());
  std::unique_ptr<Hub> hub(new Hub(settings, std::move(to_sockets), std::move(*library),
                                   std::move(*store), std::move(*lock)));
  std::vector<std::string> troubles;
  const std::vector<StoredMachine> stored = hub->store_.read_all(troubles);
  for (const std::string& trouble : troubles) hub->tell(trouble);
  for (const StoredMachine& machine : stored) hub->start(machine);
  if (stored.empty() && troubles.empty()) hub->make_first_machines();
  return hub;
}

void Hub::tell(const std::string& sentence) const {
  std::fprintf(stderr, "kerf: %s\n", output::printable(sentence).c_str());
}

// Connections

std::shared_ptr<Client> Hub::connect(Link& link) {
  thread_.here();
  auto client = std::make_shared<Client>("client-" + std::to_string(next_client_++), link);
  clients_[client.get()] = client;
  return client;
}

void Hub::disconnect(Client& client) {
  thread_.here();
  client.cut();
  leave_machine(client);
  clients_.erase(&client);
}

void Hub::close_all(const std::string& sentence) {
  thread_.here();
  const auto clients = clients_;
  for (const auto& [key, client] : clients) client->close(Link::Why::going_away, sentence);
}

void Hub::receive(const std::shared_ptr<Client>& client, std::string_view text) {
  thread_.here();
  constexpr int kMostRefused = 1000;
  const auto body = std::make_shared<const Json>(Json::parse(text, nullptr, false));
  const bool object = body->is_object();
  const Json id = object && body->contains("id") && (*body)["id"].is_primitive() ? (*body)["id"]
                                                                                 : Json(nullptr);
  const Reply reply(client, id);
  if (!client->admit_command()) {
    if (++client->refused_in_a_row > kMostRefused)
      return client->close(Link::Why::policy, "Commands came faster than the server takes them.");
    return reply.no("there are more than 200 commands a second on this connection");
  }
  client->refused_in_a_row = 0;
  if (!object) return reply.no("a command is an object of JSON, and this is none");
  if (!body->contains("do") || !(*body)["do"].is_string())
    return reply.no("the command names nothing to do: the key `do` is missing");
  const std::string name = (*body)["do"].get<std::string>();
  const Command* const command = find_command(name);
  if (command == nullptr) return reply.no("there is no command " + name.substr(0, 40));
  if (auto checked = check_arguments(*body, command->arguments, {"id", "do"}); !checked)
    return reply.no(name + ": " + checked.error().message);
  MachineRecord* const machine = client->watched();
  if (command->who != Command::Who::anyone && machine == nullptr)
    return reply.no(name + ": no machine is watched on this connection");
  if (command->who == Command::Who::op && machine->op != client.get())
    return reply.no(machine->op == nullptr
                        ? name + ": nobody operates " + machine->name + "; take control first"
                        : name + ": " + machine->name + " is operated by " + machine->op->name());
  try {
    find_handler(name)(*this, {client, machine, body, reply});
  } catch (const std::exception& fault) {
    tell(name + ": fault of Kerf itself: " + fault.what());
    reply.no(std::string("fault of Kerf itself: ") + fault.what());
  }
}

// Work elsewhere

void Hub::on_machine(const Request& request, Pace pace, MachineAction action) {
  MachineRecord& machine = *request.machine;
  machine.thread->post(machine.runner, pace,
                       [this, reply = request.reply, action = std::move(action)](Runner& runner) {
                         auto outcome = guarded([&] { return action(runner); });
                         to_sockets_([reply, outcome] { reply.with(outcome); });
                       });
}

void Hub::on_machine_durably(const Request& request, MachineAction action) {
  MachineRecord& machine = *request.machine;
  const auto job = [this, reply = request.reply, action = std::move(action),
                    name = machine.name](Runner& runner) {
    auto outcome = guarded([&] { return action(runner); });
    if (!outcome) return to_sockets_([reply, outcome] { reply.with(outcome); });
    write(reply, *outcome, [name, memory = runner.machine().memory()](const MachineStore& store) {
      return store.write_memory(name, memory);
    });
  };
  machine.thread->post(machine.runner, Pace::quick, job);
}

void Hub::write(const Reply& reply, Json answer, Writing action) {
  disk_->post([this, reply, answer = std::move(answer), action = std::move(action)] {
    const auto written = action(store_);
    const Outcome<Json> told = written ? Outcome<Json>(answer) : tl::unexpected(written.error());
    to_sockets_([reply, told] { reply.with(told); });
  });
}

void Hub::on_disk(const Request& request, std::function<Outcome<Json>(Library&)> action) {
  disk_->post([this, reply = request.reply, action = std::move(action)] {
    auto outcome = guarded([&] { return action(*library_); });
    to_sockets_([reply, outcome] { reply.with(outcome); });
  });
}

void Hub::aside(const Request& request, std::function<Outcome<Json>()> action) {
  aside_->post([this, reply = request.reply, action = std::move(action)] {
    auto outcome = guarded(action);
    to_sockets_([reply, outcome] { reply.with(outcome); });
  });
}

// What the machines tell

void Hub::published(const std::vector<Publication>& publications) {
  thread_.here();
  for (const Publication& publication : publications) {
    MachineRecord* const machine = find(publication.machine);
    if (machine == nullptr) continue;
    if (publication.snapshot) machine->snapshot = publication.snapshot;
    if (!publication.fault.empty()) {
      machine->fault = "fault of Kerf itself: " + publication.fault;
      tell(machine->name + ": " + machine->fault);
    }
    if (publication.snapshot || !publication.fault.empty()) machine->touch();
  }
}

MachineRecord* Hub::find(const std::string& name) {
  const auto found = machines_.find(name);
  return found == machines_.end() ? nullptr : found->second.get();
}

Json Hub::machine_rows() const {
  Json rows = Json::array();
  for (const auto& [name, machine] : machines_) rows.push_back(machine->row());
  return rows;
}

void Hub::tell_machines() {
  const Json event = {{"event", "machines"}, {"machines", machine_rows()}};
  const std::string text = event.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (const auto& [key, client] : clients_) client->send_text(text);
}

}  // namespace kerf::server
