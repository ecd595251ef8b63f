#pragma once

#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_disk.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/previews.hpp"

namespace kerf::server {

/// How a machine comes to another machine file. Belongs to the thread of the sockets.
class MachineFiles {
 public:
  /// All of them must outlive this.
  MachineFiles(MachineTable& machines, MachineDisk& disk, Previews& previews,
               const Answers& answers)
      : machines_(machines), disk_(disk), previews_(previews), answers_(answers) {}

  /// A command. Refused while the machine moves.
  void replace(const Request& request);

 private:
  void replace_at_rest(const StoredMachine& stored, const Reply& reply, Runner& runner);
  [[nodiscard]] base::Outcome<void> keep(const StoredMachine& stored, Runner& runner);
  void put(const StoredMachine& stored, const control::Memory& memory, const Reply& reply);

  MachineTable& machines_;
  MachineDisk& disk_;
  Previews& previews_;
  const Answers& answers_;
};

}  // namespace kerf::server
