#pragma once

#include <memory>
#include <string>

#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/features.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/part_export.hpp"
#include "face/server/hub/part.hpp"
#include "face/server/hub/part_view.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// The parts of what machines have loaded: cut while somebody wants to see one, one of each machine
/// at a time. Belongs to the thread of the sockets.
class Parts {
 public:
  /// What parts need of their server.
  struct Surroundings {
    Library& library;
    MachineTable& machines;
    const Answers& answers;
    Features& features;  ///< recognised in what they are cut from
    Worker& disk;        ///< reads and writes set-ups
    Worker& cuts;        ///< runs them
    Worker& looks;       ///< makes what is seen
  };
  /// They must outlive this, but for the workers, whose jobs use it.
  explicit Parts(Surroundings around) : around_(std::move(around)) {}

  /// From now on the part of a machine is cut from this, and shown to who has asked to see it.
  void begin(MachineRecord& machine, PartSource source);
  /// The machine has nothing loaded any more.
  void end(MachineRecord& machine);
  void cancel() const;
  /// What time brings: parts that nobody wants to see any more.
  void tick();

  // Commands

  void stock(const Request& request);
  void stock_at(const Request& request);
  void stock_probe(const Request& request);
  void stock_export(const Request& request);

  /// Has a look made for a client.
  [[nodiscard]] PartView::Look look_for(std::weak_ptr<Client> client);

 private:
  void show(Client& client, MachineRecord& machine);
  void answer_set_up(const Request& request);
  using ExportFile = std::shared_ptr<base::OutputFile>;
  void begin_export(const Reply& reply, PartExport part);
  void cut_export(const Reply& reply, const PartExport& part, const ExportFile& file);
  void keep_export(const Reply& reply, const PartExport& part, const ExportFile& file);
  void keep_set_up(const Request& request, const std::string& toml);
  void set_up_changed(MachineRecord& machine);
  /// Reads the set-up, then cuts.
  void cut_again(MachineRecord& machine);
  void cut(MachineRecord& machine, const base::Outcome<std::string>& set_up);
  void hide(MachineRecord& machine);
  void run(const std::string& name, const std::shared_ptr<Part>& part);
  void heard(const std::string& name, const std::shared_ptr<Part>& part, const Json& facts);
  void make(const std::weak_ptr<Client>& client, const PartLooking& looking);

  Surroundings around_;
  ThreadCheck thread_{"that of the sockets"};
};

}  // namespace kerf::server
