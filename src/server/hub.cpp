#include "server/hub.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "machine/language.hpp"
#include "output/diagnostic_text.hpp"
#include "server/handlers.hpp"
#include "server/program_name.hpp"
#include "server/samples.hpp"
#include "server/shown_dialect.hpp"
#include "server/state_json.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;
namespace fs = std::filesystem;

tl::unexpected<Failure> failure(Failure::Kind kind, const std::string& message) {
  return tl::unexpected(Failure{kind, message});
}

// Two servers in one folder would write over each other.
Outcome<int> lock_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return failure(Failure::Kind::output, folder + ": " + error.message());
  const std::string path = folder + "/lock";
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (descriptor < 0) return failure(Failure::Kind::output, path + ": " + std::strerror(errno));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return failure(Failure::Kind::output,
                 folder + ": another `kerf serve` is running there; --data names another folder");
}

const machine::BuiltinMachine* find_builtin(std::string_view name) {
  const auto& all = machine::builtin_machines();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Outcome<StoredMachine> new_machine(const std::string& name, const std::string& kind) {
  const machine::BuiltinMachine* const builtin = find_builtin(kind);
  if (builtin == nullptr)
    return failure(Failure::Kind::usage, "there is no built-in machine " + output::printable(kind));
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

// A fault of Kerf in a job is told to who asked; the server goes on.
template <typename Action>
Outcome<Json> guarded(Action&& action) {
  try {
    return action();
  } catch (const std::exception& fault) {
    return failure(Failure::Kind::output, std::string("fault of Kerf itself: ") + fault.what());
  }
}

}  // namespace

// Replies

void Reply::yes(Json keys) const {
  const auto client = client_.lock();
  if (!client) return;
  Json answer = {{"id", id_}, {"ok", true}};
  answer.update(keys);
  client->send(answer);
}

void Reply::no(const std::string& sentence) const {
  if (const auto client = client_.lock())
    client->send({{"id", id_}, {"ok", false}, {"error", output::printable(sentence)}});
}

void Reply::with(const Outcome<Json>& outcome) const {
  outcome ? yes(*outcome) : no(outcome.error().message);
}

// Start and end

Hub::Hub(Settings settings, ToSockets to_sockets, std::unique_ptr<Library> library,
         MachineStore store, int lock)
    : settings_(std::move(settings)),
      to_sockets_(std::move(to_sockets)),
      lock_(lock),
      library_(std::move(library)),
      store_(std::move(store)),
      disk_(std::make_unique<Worker>()),
      aside_(std::make_unique<Worker>(2, Worker::Priority::background)),
      previews_(std::make_unique<Worker>(2, Worker::Priority::background)) {
  threads_ = std::make_unique<MachineThreads>(
      settings_.threads, [this](std::vector<Publication> publications) {
        for (const Publication& each : publications) {
          if (each.memory) save_memory(each.machine, each.memory);
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
    if (auto memory = machine->runner->memory_not_told()) save_memory(name, std::move(memory));
  }
  disk_.reset();
  ::close(lock_);
}

Outcome<std::unique_ptr<Hub>> Hub::open(const Settings& settings, ToSockets to_sockets) {
  auto lock = lock_folder(settings.data);
  if (!lock) return tl::unexpected(lock.error());
  auto library = Library::open(settings.data + "/library", settings.data + "/revisions.sqlite");
  if (!library) return tl::unexpected(library.error());
  auto store = MachineStore::open(settings.data + "/machines");
  if (!store) return tl::unexpected(store.error());
  std::unique_ptr<Hub> hub(
      new Hub(settings, std::move(to_sockets), std::move(*library), std::move(*store), *lock));
  std::vector<std::string> troubles;
  const std::vector<StoredMachine> stored = hub->store_.read_all(troubles);
  for (const std::string& trouble : troubles) hub->tell(trouble);
  for (const StoredMachine& machine : stored) hub->start(machine);
  if (stored.empty() && troubles.empty()) hub->make_first_machines();
  return hub;
}

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
  start_preview(machine, stored.memory);
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
    disk_->post([this, reply, outcome, name, memory = runner.machine().memory()] {
      const auto written = store_.write_memory(name, memory);
      const Outcome<Json> told = written ? outcome : tl::unexpected(written.error());
      to_sockets_([reply, told] { reply.with(told); });
    });
  };
  machine.thread->post(machine.runner, Pace::quick, job);
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

// From any thread. A disk that is behind writes the newest memory of a machine once.
void Hub::save_memory(const std::string& name, std::shared_ptr<const control::Memory> memory) {
  {
    const std::lock_guard lock(unsaved_guard_);
    if (!unsaved_.insert_or_assign(name, std::move(memory)).second) return;
  }
  disk_->post([this, name] {
    std::unique_lock lock(unsaved_guard_);
    const auto newest = unsaved_.extract(name).mapped();
    lock.unlock();
    if (auto written = store_.write_memory(name, *newest); !written) tell(written.error().message);
  });
}

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

// Machines come and go

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
  disk_->post([this, machine = *machine, reply = request.reply] {
    const auto added = store_.add(machine);
    const Outcome<Json> told =
        added ? Outcome<Json>(Json::object()) : tl::unexpected(added.error());
    to_sockets_([reply, told] { reply.with(told); });
  });
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
  disk_->post([this, name, reply = request.reply] {
    const auto removed = store_.remove(name);
    const Outcome<Json> told =
        removed ? Outcome<Json>(Json::object()) : tl::unexpected(removed.error());
    to_sockets_([reply, told] { reply.with(told); });
  });
  tell_machines();
}

// Who watches, who operates

void Hub::watch(const Request& request) {
  const std::string name = request.arguments().text("machine");
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return request.reply.no("there is no machine " + name);
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
  start_preview(*machine, stored.memory);
  const Json event = {{"event", "definition"},
                      {"machine", name},
                      {"definition", definition_json(definition)},
                      {"settings", toml}};
  for (Client* const watcher : machine->watchers) watcher->send(event);
  disk_->post([this, stored, reply] {
    const auto written = store_.write_definition(stored.name, stored.kind, stored.toml);
    const Outcome<Json> told =
        written ? Outcome<Json>(Json::object()) : tl::unexpected(written.error());
    to_sockets_([reply, told] { reply.with(told); });
  });
}

// Programs

Outcome<machine::ProgramText> Hub::text_of(const LoadedProgram& program) const {
  if (program.text) return machine::ProgramText::of(program.name, *program.text);
  auto path = library_->path_of(program.name);
  if (!path) return tl::unexpected(path.error());
  return machine::ProgramText::at_path(*path);
}

void Hub::load(const Request& request) {
  const Arguments arguments = request.arguments();
  const bool from_library = arguments.has("program");
  if (from_library == arguments.has("text"))
    return request.reply.no("load: either `program` or `text` is needed");
  LoadedProgram program;
  program.name = arguments.text(from_library ? "program" : "name");
  if (!from_library) program.text = arguments.text("text");
  program.dialect = arguments.text("dialect");
  if (auto checked = check_program_name(program.name); !checked)
    return request.reply.no(checked.error().message);
  const auto text = text_of(program);
  if (!text) return request.reply.no(text.error().message);
  if (const auto file = text->open(); file && program.dialect.empty())
    program.dialect = dialect_shown_by(**file);
  MachineRecord& machine = *request.machine;
  machine.thread->post(
      machine.runner, Pace::slow,
      [this, text = *text, program, name = machine.name, reply = request.reply](Runner& runner) {
        const auto outcome = guarded([&]() -> Outcome<Json> {
          auto done = runner.machine().load(text, program.dialect);
          if (!done) return tl::unexpected(done.error());
          return Json::object();
        });
        if (!outcome) return to_sockets_([reply, outcome] { reply.with(outcome); });
        to_sockets_([this, name, program, reply, memory = runner.machine().memory()] {
          loaded(name, program, memory, reply);
        });
      });
}

void Hub::loaded(const std::string& name, const LoadedProgram& program,
                 const control::Memory& memory, const Reply& reply) {
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return reply.no("the machine " + name + " has been removed");
  machine->program = program;
  start_preview(*machine, memory);
  disk_->post([this, name, program, reply] {
    const auto written = store_.write_program(name, program);
    const Outcome<Json> told =
        written ? Outcome<Json>(Json{{"program", program.name}}) : tl::unexpected(written.error());
    to_sockets_([reply, told] { reply.with(told); });
  });
}

void Hub::start_preview(MachineRecord& machine, const control::Memory& memory) {
  thread_.here();
  machine.cancel_preview();
  machine.preview.reset();
  if (!machine.program) return;
  const auto text = text_of(*machine.program);
  auto chunks = ChunkStore::create(settings_.data, chunk_budget_);
  if (!text || !chunks) return;
  PreviewOrder order{machine.definition, memory, *text, machine.program->dialect,
                     library_->folder()};
  order.run = ++machine.preview_run;
  if (machine.snapshot) {
    order.skip_levels = machine.snapshot->panel.skip_levels;
    order.optional_stop = machine.snapshot->panel[machine::Switch::optional_stop];
  }
  const auto preview = std::make_shared<Preview>(std::move(order), std::move(*chunks));
  machine.preview = preview;
  machine.path = PreviewState{machine.preview_run, false, {}, {}, nullptr};
  for (Client* const watcher : machine.watchers) {
    watcher->send(machine.path_event());
    watcher->begin_chunks(preview->chunks());
  }
  machine.touch();
  previews_->post([this, preview, name = machine.name] {
    const auto tell_state = [&](const PreviewState& state) {
      to_sockets_([this, name, preview, state] { previewed(name, preview, state); });
    };
    try {
      preview->run(tell_state);
    } catch (const std::exception& fault) {
      tell(name + ": the preview: fault of Kerf itself: " + fault.what());
    }
  });
}

void Hub::renew_preview(MachineRecord& machine) {
  machine.thread->post(machine.runner, Pace::quick, [this, name = machine.name](Runner& runner) {
    to_sockets_([this, name, memory = runner.machine().memory()] {
      if (MachineRecord* const found = find(name)) start_preview(*found, memory);
    });
  });
}

void Hub::previewed(const std::string& name, const std::shared_ptr<Preview>& preview,
                    const PreviewState& state) {
  thread_.here();
  MachineRecord* const machine = find(name);
  if (machine == nullptr || machine->preview != preview) return;  // of a program before this one
  machine->path = state;
  for (Client* const watcher : machine->watchers) {
    watcher->send(machine->path_event());
    watcher->wake();
  }
  if (state.done) machine->touch();
}

}  // namespace kerf::server
