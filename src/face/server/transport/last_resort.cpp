#include "face/server/transport/last_resort.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace kerf::server {

void LastResort::begin() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(guard_);
    wake_.wait_for(lock, stop, std::chrono::milliseconds(2500), [] { return false; });
    if (stop.stop_requested()) return;
    std::fputs("kerf: something did not come to its end within 2.5 s and is left\n", stderr);
    std::_Exit(0);
  });
}

}  // namespace kerf::server
