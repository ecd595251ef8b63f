#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "base/result.hpp"
#include "face/server/hub/commands.hpp"
#include "face/server/hub/request.hpp"
#include "face/server/hub/server_clock.hpp"
#include "face/server/store/quota.hpp"

namespace kerf::server {

/// What stands between a text frame and who serves it: the rate of its client, the table of
/// commands, its date, whether the client may, and how much is under way. Belongs to the thread of
/// the sockets.
class CommandGate {
 public:
  struct Admitted {
    Request request;
    const Command* command;
  };

  /// The clock must outlive this.
  explicit CommandGate(const ServerClock& clock) : clock_(clock) {}

  /// Nothing: the client has been told why.
  [[nodiscard]] std::optional<Admitted> admit(const std::shared_ptr<Client>& client,
                                              std::string_view text);

 private:
  [[nodiscard]] base::Outcome<Admitted> checked(const std::shared_ptr<Client>& client,
                                                const std::shared_ptr<const Json>& body,
                                                std::size_t bytes);

  const ServerClock& clock_;
  Quota large_under_way_{limits::kConnections * limits::kUnderWay, limits::kBytesUnderWay};
};

}  // namespace kerf::server
