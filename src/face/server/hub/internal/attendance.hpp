#pragma once

#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/request.hpp"
#include "face/server/hub/server_clock.hpp"

namespace kerf::server {

/// Who watches a machine, and who operates it. Belongs to the thread of the sockets.
class Attendance {
 public:
  /// Both must outlive this.
  Attendance(MachineTable& machines, const ServerClock& clock)
      : machines_(machines), clock_(clock) {}

  // Commands

  void watch(const Request& request);
  void operate(const Request& request);
  void request_operation(const Request& request);
  void answer_request(const Request& request);
  void introduce(const Request& request);
  void ping(const Request& request);

  /// From the machine that he watches, if he does.
  void leave(Client& client);
  /// Requests that nobody has refused, operators who have fallen silent.
  void tick();

 private:
  void set_operator(MachineRecord& machine, Client* client);
  void end_jog(MachineRecord& machine);

  MachineTable& machines_;
  const ServerClock& clock_;
};

}  // namespace kerf::server
