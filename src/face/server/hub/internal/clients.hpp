#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "face/server/hub/client.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// Those who are connected to a server. Belongs to the thread of the sockets.
class Clients {
 public:
  /// Chunks are read by `disk`, which like `answers` must outlive this.
  Clients(Worker& disk, const Answers& answers);

  /// One more, who is told which server this is.
  [[nodiscard]] std::shared_ptr<Client> add(Link& link);
  void remove(Client& client) { clients_.erase(&client); }
  /// To each of them.
  void tell(const Json& event) const;
  void close(const std::string& sentence) const;
  void cut() const;
  [[nodiscard]] std::size_t count() const { return clients_.size(); }

 private:
  [[nodiscard]] Json hello_for(const Client& client) const;
  [[nodiscard]] Client::FetchChunk fetch_for(std::weak_ptr<Client> client) const;

  Worker& disk_;
  const Answers& answers_;
  std::string instance_;   // another one each time a server begins
  std::int64_t began_ms_;  // of the day's clock
  std::uint64_t next_ = 1;
  std::map<Client*, std::shared_ptr<Client>> clients_;
};

}  // namespace kerf::server
