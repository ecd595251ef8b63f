#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/refusal.hpp"
#include "face/server/hub/client.hpp"
#include "face/server/hub/server_clock.hpp"
#include "face/server/protocol/json.hpp"
#include "face/server/store/quota.hpp"

namespace kerf::server {

class MachineRecord;

/// Where the answer to a command goes. Copies answer the same command; the first answer counts.
class Reply {
 public:
  /// The tickets are held until the answer is given.
  Reply(std::weak_ptr<Client> client, Json id, std::vector<Quota::Ticket> tickets = {})
      : client_(std::move(client)),
        id_(std::move(id)),
        tickets_(std::make_shared<std::vector<Quota::Ticket>>(std::move(tickets))) {}

  /// `{"id":…,"ok":true}` with these keys.
  void yes(Json keys = Json::object()) const { with(std::move(keys)); }
  void no(const std::string& sentence) const;
  /// With its code and values, where it has them.
  void no(const base::Failure& failure) const;
  void no(base::Refusal refusal, std::vector<std::string> values = {}) const {
    no(base::refuse(refusal, std::move(values)));
  }
  void with(const base::Outcome<Json>& outcome) const { send(text_of(outcome)); }

  /// The answer as it travels, for send(): long ones are made by whoever computes them, on any
  /// thread. One of more than limits::kAnswerBytes becomes a refusal.
  [[nodiscard]] std::string text_of(const base::Outcome<Json>& outcome) const;
  void send(std::string text) const;
  /// The same, where the keys are JSON already: `"a":1,"b":[]`.
  [[nodiscard]] std::string text_with(std::string_view members) const;

 private:
  [[nodiscard]] std::string refusal(const base::Failure& failure) const;

  std::weak_ptr<Client> client_;
  Json id_;
  std::shared_ptr<std::vector<Quota::Ticket>> tickets_;
};

/// A command that has passed the table: its arguments are right, and who sent it may.
struct Request {
  std::shared_ptr<Client> client;
  MachineRecord* machine = nullptr;  ///< that the client watches; null: none
  std::shared_ptr<const Json> body;
  Reply reply;
  std::optional<double> given_ms{};  ///< by the clock of the server; not told: it is never late

  [[nodiscard]] Arguments arguments() const { return Arguments(*body); }
  /// Stopped when the client has left, or the server ends.
  [[nodiscard]] std::stop_token unwanted() const { return client->gone(); }
};

/// Why a command that was given at this time of the clock is not carried out any more. From any
/// thread.
[[nodiscard]] std::optional<base::Failure> too_late(const std::string& command,
                                                    const std::optional<double>& given_ms,
                                                    const ServerClock& clock);

}  // namespace kerf::server
