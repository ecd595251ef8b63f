#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

namespace kerf::server {

/// Tells the operator of the server of visitors with a wrong token: at once, then at most one line
/// every kQuiet_s, with how many there were.
class WrongTokens {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr int kQuiet_s = 10;

  void note(const std::string& address) {
    ++count_;
    const auto now = Clock::now();
    if (now < next_) return;
    std::fprintf(stderr, "kerf: a wrong token came from %s (%llu since the last line)\n",
                 address.c_str(), static_cast<unsigned long long>(count_));
    count_ = 0;
    next_ = now + std::chrono::seconds(kQuiet_s);
  }

 private:
  std::uint64_t count_ = 0;
  Clock::time_point next_{};
};

}  // namespace kerf::server
