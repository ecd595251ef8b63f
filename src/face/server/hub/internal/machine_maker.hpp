#pragma once

#include <memory>
#include <string>
#include <vector>

#include "face/server/hub/internal/attendance.hpp"
#include "face/server/hub/internal/machine_disk.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/previews.hpp"
#include "face/server/hub/internal/program_loading.hpp"
#include "face/server/store/library.hpp"

namespace kerf::server {

/// Makes machines, sets them going, and removes them. Belongs to the thread of the sockets.
class MachineMaker {
 public:
  /// What making needs of its server.
  struct Surroundings {
    Library& library;
    MachineTable& machines;
    MachineDisk& disk;
    MachineThreads& threads;
    ProgramLoading& programs;
    Previews& previews;
    Attendance& attendance;
  };
  /// They must outlive this, but for the threads: nothing is started any more when they end.
  explicit MachineMaker(Surroundings around) : around_(around) {}

  /// Those on the disk; where there has been none, those that a new server begins with. Failure:
  /// these cannot be written.
  [[nodiscard]] base::Outcome<void> start_all();

  // Commands

  void create(const Request& request);
  /// Refused while somebody else watches it.
  void remove(const Request& request);

 private:
  [[nodiscard]] base::Outcome<void> make_first_machines();
  [[nodiscard]] base::Outcome<void> add_samples();
  [[nodiscard]] base::Outcome<std::vector<StoredMachine>> add_first_machines();
  [[nodiscard]] std::shared_ptr<Runner> make_runner(const StoredMachine& stored) const;
  void start(const StoredMachine& stored);
  void created(const StoredMachine& machine, const Reply& reply);
  void removed(const std::string& name, const Reply& reply);

  Surroundings around_;
};

}  // namespace kerf::server
