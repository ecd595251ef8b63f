#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/result.hpp"
#include "face/server/transport/access.hpp"

namespace kerf::server {

/// What `kerf serve` is asked for.
struct ServeSettings {
  Address address;       ///< port 0: any free one
  std::string data;      ///< folder of programs, machines and their memory
  unsigned threads = 2;  ///< that machines run on
};

/// The server: listens, and runs machines, until a signal ends it.
class Server {
 public:
  /// Failure: the address or the data folder cannot be used.
  [[nodiscard]] static base::Outcome<std::unique_ptr<Server>> open(const ServeSettings& settings);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Where a browser finds it, with the token.
  [[nodiscard]] std::string address_line() const;
  /// Whether the page is part of this program.
  [[nodiscard]] bool has_page() const;
  /// Until SIGINT, SIGTERM or SIGHUP. Then clients are told, machines stop, memory is written.
  void run();

 private:
  class Impl;
  explicit Server(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace kerf::server
