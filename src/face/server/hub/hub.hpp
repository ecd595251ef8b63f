#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "face/server/hub/client.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/attendance.hpp"
#include "face/server/hub/internal/background_work.hpp"
#include "face/server/hub/internal/clients.hpp"
#include "face/server/hub/internal/command_gate.hpp"
#include "face/server/hub/internal/feature_edits.hpp"
#include "face/server/hub/internal/features.hpp"
#include "face/server/hub/internal/machine_disk.hpp"
#include "face/server/hub/internal/machine_files.hpp"
#include "face/server/hub/internal/machine_maker.hpp"
#include "face/server/hub/internal/machine_orders.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/parts.hpp"
#include "face/server/hub/internal/previews.hpp"
#include "face/server/hub/internal/program_loading.hpp"
#include "face/server/hub/server_clock.hpp"
#include "face/server/store/folder_lock.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/machine_store.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// Joins what a server consists of behind its connections: who is connected, which machines there
/// are, who is at them, what they have loaded, where it is kept; and has each command served.
/// Belongs to the thread of the sockets and never waits: what computes or waits for the disk is
/// done elsewhere and answers later.
class Hub {
 public:
  struct Settings {
    std::string data;  ///< folder
    unsigned threads = 2;
  };

  /// Reads what the data folder holds; makes the first machines where there are none. Failure: the
  /// folder cannot be used, or another server has it.
  [[nodiscard]] static base::Outcome<std::unique_ptr<Hub>> open(const Settings& settings,
                                                                ToSockets to_sockets);
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  // Connections

  [[nodiscard]] std::shared_ptr<Client> connect(Link& link);
  void disconnect(Client& client);
  /// A text frame of a client.
  void receive(const std::shared_ptr<Client>& client, std::string_view text);
  void close_all(const std::string& sentence);
  /// What time brings: requests that nobody has refused, clients that have fallen silent. To be
  /// called some times a second.
  void tick();
  [[nodiscard]] std::size_t connections() const { return clients_.count(); }

  // For those who serve commands

  [[nodiscard]] MachineTable& machines() { return machines_; }
  [[nodiscard]] Attendance& attendance() { return attendance_; }
  [[nodiscard]] MachineMaker& maker() { return maker_; }
  [[nodiscard]] MachineFiles& machine_files() { return machine_files_; }
  [[nodiscard]] ProgramLoading& programs() { return programs_; }
  [[nodiscard]] Features& features() { return features_; }
  [[nodiscard]] FeatureEdits& feature_edits() { return feature_edits_; }
  [[nodiscard]] Parts& parts() { return parts_; }
  [[nodiscard]] Previews& previews() { return previews_; }
  [[nodiscard]] MachineOrders& orders() { return orders_; }
  [[nodiscard]] BackgroundWork& background() { return background_; }
  [[nodiscard]] const Answers& answers() const { return answers_; }
  [[nodiscard]] Library& library() { return *library_; }
  /// Where the library is read and written.
  [[nodiscard]] Worker& disk() { return *disk_worker_; }

 private:
  Hub(const Settings& settings, ToSockets to_sockets, std::unique_ptr<Library> library,
      MachineStore store, FolderLock lock);

  void published(std::vector<Publication> publications);

  ThreadCheck thread_{"that of the sockets"};
  ServerClock clock_;
  FolderLock lock_;
  std::unique_ptr<Library> library_;
  // What works for it; ~Hub() says in which order it ends.
  std::unique_ptr<Worker> disk_worker_;
  std::unique_ptr<Worker> machine_worker_;  // nobody waits for the library there
  std::unique_ptr<Worker> aside_worker_;
  std::unique_ptr<Worker> preview_worker_;
  std::unique_ptr<Worker> cut_worker_;
  std::unique_ptr<Worker> look_worker_;
  std::unique_ptr<Worker> feature_worker_;
  // Its parts; each knows only those above it.
  Answers answers_;
  Clients clients_;
  MachineTable machines_;
  MachineDisk machine_disk_;
  CommandGate gate_;
  MachineOrders orders_;
  BackgroundWork background_;
  Attendance attendance_;
  Features features_;
  Parts parts_;
  Previews previews_;
  ProgramLoading programs_;
  FeatureEdits feature_edits_;
  MachineFiles machine_files_;
  std::unique_ptr<MachineThreads> threads_;
  MachineMaker maker_;
};

}  // namespace kerf::server
