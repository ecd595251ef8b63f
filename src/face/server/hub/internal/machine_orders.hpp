#pragma once

#include <functional>

#include "base/result.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_disk.hpp"
#include "face/server/hub/machine_threads.hpp"
#include "face/server/hub/request.hpp"
#include "face/server/hub/server_clock.hpp"

namespace kerf::server {

using MachineAction = std::function<base::Outcome<Json>(Runner&)>;

/// What the operator enters into the memory.
struct Entry {
  MachineAction act;
  /// Of what `act` has changed besides the memory. May be empty.
  std::function<void(machine::LiveMachine&)> undo{};
  /// When it is on the disk. May be empty.
  std::function<void()> done{};
};

/// What requests have done on the thread of their machine; the answer is what comes back. What is
/// slow has limits::kSlowSeconds of computing, and ends when the client leaves.
class MachineOrders {
 public:
  /// All of them must outlive this.
  MachineOrders(const Answers& answers, const ServerClock& clock, MachineDisk& disk)
      : answers_(answers), clock_(clock), disk_(disk) {}

  void give(const Request& request, Pace pace, MachineAction action);
  /// The same, answered when the memory is on the disk; until then the machine stands still. If it
  /// does not come there, or the action fails, the memory is as it was.
  void give_durably(const Request& request, Entry entry, Pace pace = Pace::quick);

 private:
  [[nodiscard]] base::Outcome<Json> done_in_time(const Request& request, Runner& runner,
                                                 const MachineAction& action) const;
  struct Entered;
  void enter(const std::shared_ptr<Entered>& entered, Runner& runner);
  void keep(const Entered& entered, Runner& runner);

  const Answers& answers_;
  const ServerClock& clock_;
  MachineDisk& disk_;
};

}  // namespace kerf::server
