#pragma once

#include <functional>
#include <string>

#include "base/result.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/store/machine_store.hpp"
#include "face/server/store/memory_keeper.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// Where machines are kept: their folder, what of their memory is there, and the thread that waits
/// for it.
class MachineDisk {
 public:
  using Writing = std::function<base::Outcome<void>(const MachineStore&)>;

  /// What is given must outlive this, but for `worker`, whose jobs use it.
  MachineDisk(MachineStore store, Worker& worker, const Answers& answers, MachineTable& machines);

  /// There; then `done` on the thread of the sockets, and where it failed the reply is why.
  void write(const Reply& reply, Writing action, std::function<void(base::Outcome<void>)> done);
  /// The memory of all machines. Precondition: no thread runs them any more.
  void save_at_the_end();

  [[nodiscard]] const MachineStore& store() const { return store_; }
  [[nodiscard]] MemoryKeeper& memories() { return memories_; }
  [[nodiscard]] Worker& worker() { return worker_; }

 private:
  [[nodiscard]] bool save_all(bool tells_losses);

  MachineStore store_;
  Worker& worker_;
  const Answers& answers_;
  MachineTable& machines_;
  MemoryKeeper memories_;
};

}  // namespace kerf::server
