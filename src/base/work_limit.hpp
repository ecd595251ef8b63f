#pragma once

#include <chrono>
#include <stop_token>
#include <string>
#include <utility>

namespace kerf::base {

/// How long a computation may go on: until its time is over, or until nobody wants its result any
/// more. Whoever computes for long asks reached() every few milliseconds and comes to an end; what
/// it has until then may be incomplete. Copies share the token, which any thread may stop.
class WorkLimit {
 public:
  using Clock = std::chrono::steady_clock;

  WorkLimit() = default;  ///< none
  /// `seconds` from now on; 0: as long as somebody wants it.
  explicit WorkLimit(double seconds, std::stop_token unwanted = {})
      : begin_(Clock::now()), seconds_(seconds), unwanted_(std::move(unwanted)) {}

  [[nodiscard]] bool unwanted() const { return unwanted_.stop_requested(); }
  [[nodiscard]] bool out_of_time() const {
    const std::chrono::duration<double> elapsed = Clock::now() - begin_;
    return seconds_ > 0 && elapsed.count() > seconds_;
  }
  [[nodiscard]] bool reached() const { return unwanted() || out_of_time(); }
  [[nodiscard]] const std::stop_token& token() const { return unwanted_; }
  /// Why it is reached, as the end of a sentence: "60 s of computing are over".
  [[nodiscard]] std::string reason() const;

 private:
  Clock::time_point begin_{};
  double seconds_ = 0;
  std::stop_token unwanted_;
};

}  // namespace kerf::base
