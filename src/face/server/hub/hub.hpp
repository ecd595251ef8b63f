#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "face/server/hub/client.hpp"
#include "face/server/hub/machine_record.hpp"
#include "face/server/hub/machine_threads.hpp"
#include "face/server/hub/request.hpp"
#include "face/server/hub/server_clock.hpp"
#include "face/server/store/folder_lock.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/machine_store.hpp"
#include "face/server/store/memory_keeper.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// Hands something to the thread of the sockets. From any thread.
using ToSockets = std::function<void(std::function<void()>)>;

/// The machines of a server and those who are connected: who watches what, who operates what, and
/// which command goes where. Belongs to the thread of the sockets and never waits: what computes or
/// waits for the disk is done elsewhere and answers later.
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

  // For those who serve commands

  using MachineAction = std::function<base::Outcome<Json>(Runner&)>;
  /// On the thread of the request's machine; the answer is what comes back. What is slow has
  /// limits::kSlowSeconds of computing, and ends when the client leaves.
  void on_machine(const Request& request, Pace pace, MachineAction action);
  /// What the operator enters into the memory.
  struct Entry {
    MachineAction act;
    /// Of what `act` has changed besides the memory. May be empty.
    std::function<void(machine::LiveMachine&)> undo{};
    /// When it is on the disk. May be empty.
    std::function<void()> done{};
  };
  /// The same, answered when the memory is on the disk; until then the machine stands still. If it
  /// does not come there, or the action fails, the memory is as it was.
  void on_machine_durably(const Request& request, Entry entry, Pace pace = Pace::quick);
  using DiskAction = std::function<base::Outcome<Json>(Library&)>;
  /// Where files are read; the answer is what comes back. Not done for a client who has left.
  void read_disk(const Request& request, DiskAction action);
  /// The same where they are changed: what was taken is done, whoever leaves.
  void change_disk(const Request& request, DiskAction action);
  using AsideAction = std::function<base::Outcome<Json>(const base::WorkLimit& limit)>;
  /// For work that may take long and touches nothing of the hub: one at a time of each client. It
  /// is to keep to its limit, limits::kAsideSeconds of computing; a client who leaves ends it.
  void aside(const Request& request, AsideAction action);
  /// Back on the thread of the sockets.
  void to_sockets(std::function<void()> action) const { to_sockets_(std::move(action)); }

  [[nodiscard]] MachineRecord* find(const std::string& name);
  [[nodiscard]] Json machine_rows() const;
  void create(const Request& request);
  void remove(const Request& request);
  void watch(const Request& request);
  void operate(const Request& request);
  void request_operation(const Request& request);
  void answer_request(const Request& request);
  void introduce(const Request& request);
  void ping(const Request& request);
  void load(const Request& request);
  void replace_definition(const Request& request);
  /// A sentence of the disk as a client may read it.
  [[nodiscard]] std::string without_folder(std::string sentence) const;
  /// Once more, because what it runs with has changed.
  void renew_preview(MachineRecord& machine);

  [[nodiscard]] Library& library() { return *library_; }
  /// Where the library is read and written.
  [[nodiscard]] Worker& disk() { return *disk_; }
  [[nodiscard]] std::size_t connections() const { return clients_.size(); }

 private:
  Hub(Settings settings, ToSockets to_sockets, std::unique_ptr<Library> library, MachineStore store,
      FolderLock lock);

  using Writing = std::function<base::Outcome<void>(const MachineStore&)>;
  /// From any thread: the answer is made here and sent there.
  void answer(const Reply& reply, const base::Outcome<Json>& outcome) const;
  void do_on_disk(const Reply& reply, std::stop_token unwanted, DiskAction action);
  void refuse_haste(Client& client, const Reply& reply);
  void serve(const Request& request, const Command& command);
  /// Where machines are kept; then `done` on the thread of the sockets, or the reply is why not.
  void write(const Reply& reply, Writing action, std::function<void(base::Outcome<void>)> done);
  /// From where `definition` says that the axes stand.
  [[nodiscard]] job::Job job_of(const MachineRecord& machine,
                                const machine::MachineDefinition& definition,
                                const control::Memory& memory) const;
  void start_preview(MachineRecord& machine, const machine::MachineDefinition& definition,
                     const control::Memory& memory);
  void load_into(MachineRecord& machine);
  [[nodiscard]] base::Outcome<void> keep_definition(const StoredMachine& stored, Runner& runner);
  void put_definition(const StoredMachine& stored, const Reply& reply);
  [[nodiscard]] base::Outcome<void> make_first_machines();
  [[nodiscard]] base::Outcome<std::vector<StoredMachine>> add_first_machines();
  void take_out(const std::string& name);
  void unsaved(const std::string& machine, const std::string& trouble);
  void save_at_the_end();
  void start(const StoredMachine& stored);
  void published(const std::vector<Publication>& publications);
  void previewed(const std::string& machine, const std::shared_ptr<Preview>& preview,
                 const PreviewState& state);
  void leave_machine(Client& client);
  void set_operator(MachineRecord& machine, Client* client);
  void end_jog(MachineRecord& machine);
  [[nodiscard]] Json hello_for(const Client& client) const;
  /// Why a command is not carried out any more. From any thread.
  [[nodiscard]] std::optional<base::Failure> too_late(const std::string& command,
                                                      const std::optional<double>& given_ms) const;
  [[nodiscard]] base::Outcome<Json> done_in_time(const Request& request, Runner& runner,
                                                 const MachineAction& action) const;
  void tell_machines();
  void tell(const std::string& sentence) const;
  /// A program that can be opened, with its dialect.
  struct FoundProgram {
    base::ProgramText text;
    LoadedProgram program;
  };
  [[nodiscard]] base::Outcome<FoundProgram> found(const LoadedProgram& program,
                                                  const machine::MachineDefinition& machine) const;
  void keep_and_load(const std::string& machine, MachineThread& thread,
                     const std::shared_ptr<Runner>& held, const FoundProgram& found,
                     const Reply& reply);
  /// A machine at one moment, as a preview begins with it.
  struct PreviewBasis {
    machine::MachineDefinition definition;
    control::Memory memory;
    std::shared_ptr<const machine::Snapshot> snapshot;
  };
  [[nodiscard]] static PreviewBasis basis_of(Runner& runner);
  void preview_from(MachineRecord& machine, const PreviewBasis& basis);
  void loaded(const std::string& machine, const LoadedProgram& program, const PreviewBasis& basis,
              const Reply& reply);
  /// As the machine runs it: of a pattern its listing.
  [[nodiscard]] base::Outcome<base::ProgramText> text_of(
      const LoadedProgram& program, const machine::MachineDefinition& machine) const;
  [[nodiscard]] std::shared_ptr<Runner> make_runner(const StoredMachine& stored) const;

  ThreadCheck thread_{"that of the sockets"};
  ServerClock clock_;
  std::string instance_;   // another one each time a server begins
  std::int64_t began_ms_;  // of the day's clock
  Settings settings_;
  ToSockets to_sockets_;
  FolderLock lock_;
  std::unique_ptr<Library> library_;
  MachineStore store_;
  std::map<std::string, std::unique_ptr<MachineRecord>> machines_;
  std::map<Client*, std::shared_ptr<Client>> clients_;
  std::shared_ptr<ChunkBudget> chunk_budget_ = std::make_shared<ChunkBudget>();
  std::set<std::string> under_way_;  // machines that are being made or removed
  std::uint64_t next_client_ = 1;
  Quota large_under_way_{limits::kConnections * limits::kUnderWay, limits::kBytesUnderWay};
  // What works for it; in the order in which it ends, last first.
  std::unique_ptr<Worker> disk_;
  std::unique_ptr<Worker> machine_disk_;  // nobody waits for the library there
  MemoryKeeper keeper_;
  std::unique_ptr<Worker> aside_;
  std::unique_ptr<Worker> previews_;
  std::unique_ptr<MachineThreads> threads_;
};

}  // namespace kerf::server
