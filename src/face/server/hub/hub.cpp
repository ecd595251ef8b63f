#include "face/server/hub/hub.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/handlers.hpp"
#include "face/server/protocol/json_shape.hpp"
#include "face/server/protocol/language_json.hpp"
#include "face/server/store/private_files.hpp"
#include "output/writing/diagnostic_text.hpp"

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
  for (const auto& [key, client] : clients_) client->cut();
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
  client->set_fetch([this, weak = std::weak_ptr(client)](const std::shared_ptr<ChunkStore>& store,
                                                         std::size_t number) {
    disk_->post([this, weak, store, number] {
      to_sockets_([weak, store, number, chunk = store->read(number)] {
        if (const auto reader = weak.lock()) reader->take_chunk(store, number, chunk);
      });
    });
  });
  client->send(hello_for(*client));
  return client;
}

Json Hub::hello_for(const Client& client) const {
  return {{"event", "hello"},
          {"protocol", kProtocol},
          {"server", instance_},
          {"began_ms", began_ms_},
          {"client", client.name()},
          {"dialects", dialects_json()},
          {"token_kinds", token_kinds_json()}};
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

namespace {

// To read so much costs nothing, so that even what is refused unread is answered by its id.

Json id_of(const Json& body) {
  const bool has_id = body.is_object() && body.contains("id") && body["id"].is_primitive();
  return has_id ? body["id"] : Json(nullptr);
}

// The command that a text asks for, its arguments held against the table. Failure (usage).
Outcome<const Command*> command_of(const Json& body) {
  const auto wrong = [](const std::string& sentence) {
    return tl::unexpected(base::Failure{base::Failure::Kind::usage, sentence});
  };
  if (!body.is_object()) return wrong("a command is an object of JSON, and this is none");
  if (!body.contains("do") || !body["do"].is_string())
    return wrong("the command names nothing to do: the key `do` is missing");
  const std::string name = body["do"].get<std::string>();
  const Command* const command = find_command(name);
  if (command == nullptr) return wrong("there is no command " + name.substr(0, 40));
  if (auto checked = check_arguments(body, command->arguments, {"id", "do", "at_ms"}); !checked) {
    base::Failure failure = checked.error();
    failure.message = name + ": " + failure.message;
    return tl::unexpected(std::move(failure));
  }
  return command;
}

// Whether a command is for this client. Failure (usage): why not.
Outcome<void> check_who(const Command& command, const Client& client) {
  const std::string name(command.name);
  const MachineRecord* const machine = client.watched();
  if (command.who == Command::Who::anyone) return {};
  if (machine == nullptr)
    return tl::unexpected(base::Failure{base::Failure::Kind::usage,
                                        name + ": no machine is watched on this connection"});
  if (command.who != Command::Who::op || machine->op == &client) return {};
  if (machine->op == nullptr)
    return tl::unexpected(base::refuse(base::Refusal::operated_by_nobody, {name, machine->name}));
  return tl::unexpected(base::refuse(base::Refusal::operated_by_another,
                                     {name, machine->name, machine->op->shown_name()}));
}

}  // namespace

void Hub::receive(const std::shared_ptr<Client>& client, std::string_view text) {
  thread_.here();
  const bool admitted = client->admit_command();
  const bool is_read = admitted || text.size() <= limits::kSmallBytes;
  const auto objection = is_read ? objection_to_shape(text) : std::nullopt;
  const auto body = std::make_shared<const Json>(
      is_read && !objection ? Json::parse(text, nullptr, false) : Json(Json::value_t::discarded));
  const Reply refusal(client, id_of(*body));
  if (!admitted) return refuse_haste(*client, refusal);
  client->refused_in_a_row = 0;
  client->hear(clock_.now_ms());
  if (objection) return refusal.no(*objection);
  const auto command = command_of(*body);
  if (!command) return refusal.no(command.error());
  const auto given = given_ms(*body);
  if (!given) return refusal.no(std::string((*command)->name) + ": " + given.error().message);
  if (const auto late = too_late(std::string((*command)->name), *given)) return refusal.no(*late);
  if (auto suits = check_who(**command, *client); !suits) return refusal.no(suits.error());
  Quota::Ticket mine = client->begin_command();
  if (!mine) return refusal.no(base::Refusal::under_way, {std::to_string(limits::kUnderWay)});
  Quota::Ticket ours = large_under_way_.take(text.size() > limits::kSmallBytes ? text.size() : 0);
  if (!ours) return refusal.no(base::Refusal::server_busy);
  serve({client, client->watched(), body, Reply(client, id_of(*body), {mine, ours}), *given},
        **command);
}

void Hub::refuse_haste(Client& client, const Reply& reply) {
  constexpr int kMostRefused = 1000;
  if (++client.refused_in_a_row > kMostRefused)
    return client.close(Link::Why::policy, "Commands came faster than the server takes them.");
  reply.no(base::Refusal::too_fast);
}

void Hub::serve(const Request& request, const Command& command) {
  const std::string name(command.name);
  try {
    find_handler(command.name)(*this, request);
  } catch (const std::exception& fault) {
    tell(name + ": fault of Kerf itself: " + fault.what());
    request.reply.no(base::Refusal::own_fault, {fault.what()});
  }
}

// Work elsewhere

// Where the server keeps its data is nobody's business.
std::string Hub::without_folder(std::string sentence) const {
  const std::string folder = settings_.data + "/";
  for (std::size_t at = 0; (at = sentence.find(folder, at)) != std::string::npos;)
    sentence.erase(at, folder.size());
  return sentence;
}

void Hub::answer(const Reply& reply, const Outcome<Json>& made) const {
  Outcome<Json> outcome = made;
  if (!outcome) outcome.error().message = without_folder(std::move(outcome.error().message));
  to_sockets_([reply, text = reply.text_of(outcome)] { reply.send(text); });
}

void Hub::on_machine(const Request& request, Pace pace, MachineAction action) {
  MachineRecord& machine = *request.machine;
  machine.thread->post(machine.runner, pace,
                       [this, request, action = std::move(action)](Runner& runner) {
                         answer(request.reply, done_in_time(request, runner, action));
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
  if (late) return tl::unexpected(*late);
  runner.machine().set_limit(base::WorkLimit(limits::kSlowSeconds, request.unwanted()));
  const auto outcome = guarded([&] { return action(runner); });
  runner.machine().set_limit({});
  return outcome;
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
    if (!outcome) return answer(reply, outcome);
    const auto keep = [this, reply, entry, name, before, after, outcome](Runner& at_disk) {
      const auto written = keeper_.write(name, after);
      if (!written) {
        at_disk.machine().set_memory(before);
        if (entry.undo) entry.undo(at_disk.machine());
        return answer(reply, tl::unexpected(written.error()));
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
    to_sockets_([this, reply, written, done] {
      done(written);
      if (!written) reply.no(without_folder(written.error().message));
    });
  });
}

void Hub::do_on_disk(const Reply& reply, std::stop_token unwanted, DiskAction action) {
  disk_->post({.work =
                   [this, reply, action = std::move(action)] {
                     answer(reply, guarded([&] { return action(*library_); }));
                   },
               .unwanted = std::move(unwanted)});
}

void Hub::read_disk(const Request& request, DiskAction action) {
  do_on_disk(request.reply, request.unwanted(), std::move(action));
}

void Hub::change_disk(const Request& request, DiskAction action) {
  do_on_disk(request.reply, {}, std::move(action));
}

void Hub::aside(const Request& request, AsideAction action) {
  const std::stop_token unwanted = request.unwanted();
  aside_->post({.work =
                    [this, reply = request.reply, action = std::move(action), unwanted] {
                      const base::WorkLimit limit(limits::kAsideSeconds, unwanted);
                      answer(reply, guarded([&] { return action(limit); }));
                    },
                .unwanted = unwanted,
                .owner = request.client.get()});
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
