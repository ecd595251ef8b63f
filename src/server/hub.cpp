#include "server/hub.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

#include "output/diagnostic_text.hpp"
#include "server/guarded.hpp"
#include "server/handlers.hpp"
#include "server/private_files.hpp"

namespace kerf::server {

using base::Outcome;

namespace {

std::string random_name() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

std::int64_t now_ms_since_epoch() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

// The time at which a command was given; nothing else of a frame may be a number besides its id.
Outcome<std::optional<double>> given_ms(const Json& body) {
  if (!body.contains("at_ms")) return std::nullopt;
  const Json& at = body["at_ms"];
  if (at.is_number() && std::isfinite(at.get<double>())) return at.get<double>();
  return tl::unexpected(base::Failure{base::Failure::Kind::usage,
                                      "at_ms must be a number: ms of the server's clock"});
}

}  // namespace

// Start and end

Hub::Hub(Settings settings, ToSockets to_sockets, std::unique_ptr<Library> library,
         MachineStore store, FolderLock lock)
    : instance_(random_name()),
      began_ms_(now_ms_since_epoch()),
      settings_(std::move(settings)),
      to_sockets_(std::move(to_sockets)),
      lock_(std::move(lock)),
      library_(std::move(library)),
      store_(std::move(store)),
      disk_(std::make_unique<Worker>()),
      machine_disk_(std::make_unique<Worker>()),
      keeper_(
          *machine_disk_,
          [this](const std::string& machine, const control::Memory& memory) {
            return store_.write_memory(machine, memory);
          },
          [this](const std::string& machine, const std::string& trouble) {
            to_sockets_([this, machine, trouble] { unsaved(machine, trouble); });
          }),
      aside_(std::make_unique<Worker>(2, Worker::Priority::background)),
      previews_(std::make_unique<Worker>(2, Worker::Priority::background)) {
  threads_ = std::make_unique<MachineThreads>(
      settings_.threads, [this](std::vector<Publication> publications) {
        for (const Publication& each : publications) {
          if (each.memory) keeper_.offer(each.machine, each.memory);
        }
        std::erase_if(publications, [](const Publication& each) { return each.memory != nullptr; });
        if (publications.empty()) return;
        to_sockets_([this, publications = std::move(publications)] { published(publications); });
      });
}

// Machines stop, then what their memory holds is written, then the threads end.
Hub::~Hub() {
  for (const auto& [name, machine] : machines_) machine->cancel_preview();
  threads_.reset();
  previews_.reset();
  aside_.reset();
  machine_disk_.reset();
  save_at_the_end();
  disk_.reset();
}

// A disk that is full for a moment has some time.
void Hub::save_at_the_end() {
  constexpr int kTries = 5;
  constexpr auto kPause = std::chrono::milliseconds(200);
  for (int tries = 1; tries <= kTries; ++tries) {
    bool all = true;
    for (const auto& [name, machine] : machines_) {
      const auto written = keeper_.write(name, machine->runner->last_memory());
      all &= written.has_value();
      if (!written && tries == kTries)
        tell("the memory of " + name + " has changes that are lost: " + written.error().message);
    }
    if (all) return;
    std::this_thread::sleep_for(kPause);
  }
}

Outcome<std::unique_ptr<Hub>> Hub::open(const Settings& settings, ToSockets to_sockets) {
  const auto was_open = make_private_folder(settings.data);
  if (!was_open) return tl::unexpected(was_open.error());
  auto lock = FolderLock::take(settings.data);
  if (!lock) return tl::unexpected(lock.error());
  remove_unfinished(settings.data);
  auto library = Library::open(settings.data + "/library", settings.data + "/revisions.sqlite");
  if (!library) return tl::unexpected(library.error());
  auto store = MachineStore::open(settings.data + "/machines");
  if (!store) return tl::unexpected(store.error());
  std::unique_ptr<Hub> hub(new Hub(settings, std::move(to_sockets), std::move(*library),
                                   std::move(*store), std::move(*lock)));
  if (*was_open)
    hub->tell(settings.data + ": other accounts could open this folder; it is closed to them now");
  std::vector<std::string> troubles;
  const std::vector<StoredMachine> stored = hub->store_.read_all(troubles);
  for (const std::string& trouble : troubles) hub->tell(trouble);
  for (const StoredMachine& machine : stored) hub->start(machine);
  if (!stored.empty() || !troubles.empty()) return hub;
  if (auto made = hub->make_first_machines(); !made) return tl::unexpected(made.error());
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
  client->send(hello_for(*client));
  return client;
}

Json Hub::hello_for(const Client& client) const {
  return {{"event", "hello"},
          {"protocol", kProtocol},
          {"server", instance_},
          {"began_ms", began_ms_},
          {"client", client.name()}};
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
  client->hear(clock_.now_ms());
  if (!object) return reply.no("a command is an object of JSON, and this is none");
  if (!body->contains("do") || !(*body)["do"].is_string())
    return reply.no("the command names nothing to do: the key `do` is missing");
  const std::string name = (*body)["do"].get<std::string>();
  const Command* const command = find_command(name);
  if (command == nullptr) return reply.no("there is no command " + name.substr(0, 40));
  if (auto checked = check_arguments(*body, command->arguments, {"id", "do", "at_ms"}); !checked)
    return reply.no(name + ": " + checked.error().message);
  const auto given = given_ms(*body);
  if (!given) return reply.no(name + ": " + given.error().message);
  if (const auto late = too_late(name, *given)) return reply.no(*late);
  MachineRecord* const machine = client->watched();
  if (command->who != Command::Who::anyone && machine == nullptr)
    return reply.no(name + ": no machine is watched on this connection");
  if (command->who == Command::Who::op && machine->op != client.get())
    return machine->op == nullptr
               ? reply.no(base::Refusal::operated_by_nobody, {name, machine->name})
               : reply.no(base::Refusal::operated_by_another,
                          {name, machine->name, machine->op->shown_name()});
  try {
    find_handler(name)(*this, {client, machine, body, reply, *given});
  } catch (const std::exception& fault) {
    tell(name + ": fault of Kerf itself: " + fault.what());
    reply.no(std::string("fault of Kerf itself: ") + fault.what());
  }
}

// Work elsewhere

void Hub::on_machine(const Request& request, Pace pace, MachineAction action) {
  MachineRecord& machine = *request.machine;
  machine.thread->post(machine.runner, pace,
                       [this, request, action = std::move(action)](Runner& runner) {
                         auto outcome = done_in_time(request, runner, action);
                         to_sockets_([reply = request.reply, outcome] { reply.with(outcome); });
                       });
}

std::optional<base::Failure> Hub::too_late(const std::string& command,
                                           const std::optional<double>& given_ms) const {
  const double age_ms = given_ms ? clock_.now_ms() - *given_ms : 0;
  if (age_ms <= limits::kLateMs) return std::nullopt;
  return base::refuse(base::Refusal::late, {command, fmt::format("{:.1f}", age_ms / 1000),
                                            std::to_string(limits::kLateMs / 1000)});
}

// Asked again where it is done: a command may have waited behind another one.
Outcome<Json> Hub::done_in_time(const Request& request, Runner& runner,
                                const MachineAction& action) const {
  const auto late = too_late((*request.body)["do"].get<std::string>(), request.given_ms);
  if (!late) return guarded([&] { return action(runner); });
  return tl::unexpected(*late);
}

void Hub::on_machine_durably(const Request& request, Entry entry, Pace pace) {
  MachineRecord& machine = *request.machine;
  const auto job = [this, request, reply = request.reply, entry = std::move(entry),
                    name = machine.name, thread = machine.thread,
                    held = machine.runner](Runner& runner) {
    const control::Memory before = runner.machine().memory();
    const auto outcome = done_in_time(request, runner, entry.act);
    const control::Memory after = runner.machine().memory();
    if (!outcome && !keeps_the_same(before, after)) runner.machine().set_memory(before);
    if (!outcome) return to_sockets_([reply, outcome] { reply.with(outcome); });
    const auto keep = [this, reply, entry, name, before, after, outcome](Runner& at_disk) {
      const auto written = keeper_.write(name, after);
      if (!written) {
        at_disk.machine().set_memory(before);
        if (entry.undo) entry.undo(at_disk.machine());
        return to_sockets_([reply, why = written.error()] { reply.no(why); });
      }
      to_sockets_([reply, outcome, done = entry.done] {
        if (done) done();
        reply.with(outcome);
      });
    };
    keeper_.is_on_disk(name, after) ? keep(runner) : thread->lend(held, *machine_disk_, keep);
  };
  machine.thread->post(machine.runner, pace, job);
}

void Hub::write(const Reply& reply, Writing action, std::function<void(Outcome<void>)> done) {
  machine_disk_->post([this, reply, action = std::move(action), done = std::move(done)] {
    const auto written = guarded([&] { return action(store_); });
    to_sockets_([reply, written, done] {
      done(written);
      if (!written) reply.no(written.error().message);
    });
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

// Everybody who watches it sees it while it lasts.
void Hub::unsaved(const std::string& name, const std::string& trouble) {
  thread_.here();
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return;
  tell("the memory of " + name +
       (trouble.empty() ? " is on the disk again" : " cannot be written: " + trouble));
  machine->unsaved = trouble;
  machine->touch();
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
