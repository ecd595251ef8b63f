#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/refusal.hpp"
#include "server/argument.hpp"
#include "server/client.hpp"

namespace kerf::server {

class MachineRecord;

/// Where the answer to a command goes. Copies answer the same command; the first answer counts.
class Reply {
 public:
  Reply(std::weak_ptr<Client> client, Json id) : client_(std::move(client)), id_(std::move(id)) {}

  /// `{"id":…,"ok":true}` with these keys.
  void yes(Json keys = Json::object()) const;
  void no(const std::string& sentence) const;
  /// With its code and values, where it has them.
  void no(const base::Failure& failure) const;
  void no(base::Refusal refusal, std::vector<std::string> values = {}) const {
    no(base::refuse(refusal, std::move(values)));
  }
  void with(const base::Outcome<Json>& outcome) const;

 private:
  std::weak_ptr<Client> client_;
  Json id_;
};

/// A command that has passed the table: its arguments are right, and who sent it may.
struct Request {
  std::shared_ptr<Client> client;
  MachineRecord* machine = nullptr;  ///< that the client watches; null: none
  std::shared_ptr<const Json> body;
  Reply reply;
  std::optional<double> given_ms{};  ///< by the clock of the server; not told: it is never late

  [[nodiscard]] Arguments arguments() const { return Arguments(*body); }
};

}  // namespace kerf::server
