#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace kerf::cli {

/// A line on standard error that tells how far a long run has come, while standard error is a
/// terminal. Nothing is shown in the first half second; the line goes when the object does.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  [[nodiscard]] bool wanted() const { return terminal_; }
  /// `done` of `total` bytes of the program are behind the tool.
  void show(std::uint64_t done, std::uint64_t total, std::uint64_t motions);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace kerf::cli
