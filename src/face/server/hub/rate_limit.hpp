#pragma once

#include <algorithm>
#include <chrono>

namespace kerf::server {

/// Lets through `per_second` things on average and `burst` at once.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;

  RateLimit(double per_second, double burst) : per_second_(per_second), burst_(burst) {}

  [[nodiscard]] bool admit(Clock::time_point now) {
    const std::chrono::duration<double> passed = now - last_;
    left_ = first_ ? burst_ : std::min(burst_, left_ + passed.count() * per_second_);
    first_ = false;
    last_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  double per_second_;
  double burst_;
  double left_ = 0;
  bool first_ = true;
  Clock::time_point last_{};
};

}  // namespace kerf::server
