#pragma once

#include <chrono>

namespace kerf::server {

/// The clock that commands are dated by: milliseconds since the server began. It never goes back
/// and has nothing to do with the time of day. From any thread.
class ServerClock {
 public:
  [[nodiscard]] double now_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began_)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace kerf::server
