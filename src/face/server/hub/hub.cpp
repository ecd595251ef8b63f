#include "face/server/hub/hub.hpp"

#include "face/server/hub/handlers.hpp"
#include "face/server/hub/internal/console.hpp"
#include "face/server/store/private_files.hpp"

namespace kerf::server {

using base::Outcome;

// Start and end

Hub::Hub(const Settings& settings, ToSockets to_sockets, std::unique_ptr<Library> library,
         MachineStore store, FolderLock lock)
    : lock_(std::move(lock)),
      library_(std::move(library)),
      disk_worker_(std::make_unique<Worker>()),
      machine_worker_(std::make_unique<Worker>()),
      aside_worker_(std::make_unique<Worker>(2, Worker::Priority::background)),
      preview_worker_(std::make_unique<Worker>(2, Worker::Priority::background)),
      cut_worker_(std::make_unique<Worker>(2, Worker::Priority::background)),
      look_worker_(std::make_unique<Worker>(2, Worker::Priority::background)),
      feature_worker_(std::make_unique<Worker>(2, Worker::Priority::background)),
      answers_(std::move(to_sockets), settings.data),
      clients_(*disk_worker_, answers_),
      machines_(clients_),
      machine_disk_(std::move(store), *machine_worker_, answers_, machines_),
      gate_(clock_),
      orders_(answers_, clock_, machine_disk_),
      background_(*library_, *disk_worker_, *aside_worker_, answers_),
      attendance_(machines_, clock_),
      features_({*library_, machines_, answers_, *disk_worker_, *feature_worker_}),
      parts_(
          {*library_, machines_, answers_, features_, *disk_worker_, *cut_worker_, *look_worker_}),
      previews_({settings.data, *library_, machines_, answers_, clock_, parts_, *preview_worker_}),
      programs_({*library_, machines_, machine_disk_, previews_, answers_, *disk_worker_}),
      feature_edits_(
          {*library_, machines_, answers_, features_, programs_, *disk_worker_, *feature_worker_}),
      machine_files_(machines_, machine_disk_, previews_, answers_),
      threads_(std::make_unique<MachineThreads>(
          settings.threads, [this](std::vector<Publication> made) { published(std::move(made)); })),
      maker_({*library_, machines_, machine_disk_, *threads_, programs_, previews_, attendance_}) {}

// Machines stop, then what their memory holds is written, then the threads end.
Hub::~Hub() {
  previews_.cancel();
  parts_.cancel();
  features_.cancel();
  clients_.cut();
  threads_.reset();
  preview_worker_.reset();
  cut_worker_.reset();
  look_worker_.reset();
  feature_worker_.reset();
  aside_worker_.reset();
  machine_worker_.reset();
  machine_disk_.save_at_the_end();
  disk_worker_.reset();
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
    tell_console(settings.data +
                 ": other accounts could open this folder; it is closed to them now");
  if (auto started = hub->maker_.start_all(); !started) return tl::unexpected(started.error());
  return hub;
}

// On the thread of a machine: what is to be on the disk goes there, the rest to those who watch.
void Hub::published(std::vector<Publication> publications) {
  for (const Publication& each : publications) {
    if (each.memory) machine_disk_.memories().offer(each.machine, each.memory);
  }
  std::erase_if(publications, [](const Publication& each) { return each.memory != nullptr; });
  if (publications.empty()) return;
  answers_.to_sockets(
      [this, publications = std::move(publications)] { machines_.published(publications); });
}

// Connections

std::shared_ptr<Client> Hub::connect(Link& link) {
  thread_.here();
  auto client = clients_.add(link);
  client->part().set_look(parts_.look_for(client));
  return client;
}

void Hub::disconnect(Client& client) {
  thread_.here();
  client.cut();
  attendance_.leave(client);
  clients_.remove(client);
}

void Hub::close_all(const std::string& sentence) {
  thread_.here();
  clients_.close(sentence);
}

void Hub::tick() {
  thread_.here();
  attendance_.tick();
  previews_.tick();
  parts_.tick();
  features_.tick();
}

void Hub::receive(const std::shared_ptr<Client>& client, std::string_view text) {
  thread_.here();
  const auto admitted = gate_.admit(client, text);
  if (!admitted) return;
  const auto& [request, command] = *admitted;
  try {
    find_handler(command->name)(*this, request);
  } catch (const std::exception& fault) {
    tell_console(std::string(command->name) + ": fault of Kerf itself: " + fault.what());
    request.reply.no(base::Refusal::own_fault, {fault.what()});
  }
}

}  // namespace kerf::server
