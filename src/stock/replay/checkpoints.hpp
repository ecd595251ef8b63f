#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "stock/replay/tiles.hpp"

namespace kerf::stock::replay {

/// A model behind so many steps.
struct Checkpoint {
  std::size_t steps = 0;
  Moment moment;
};

/// Moments of a model on its way, from the first one on: one every interval of computing. Where
/// they need more memory than they may, every second of them goes, and the interval doubles.
class Checkpoints {
 public:
  struct Settings {
    std::size_t memory_bytes = 0;
    double interval_s = 0.25;
  };
  explicit Checkpoints(const Settings& settings) : settings_(settings) {}

  /// Whether the next one is due, behind these steps.
  [[nodiscard]] bool is_due(std::size_t steps) const;
  void add(Checkpoint checkpoint);
  /// The last one that is not behind these steps. None: there is none.
  [[nodiscard]] const Checkpoint* before(std::size_t steps) const;
  [[nodiscard]] std::size_t count() const { return list_.size(); }
  /// Of all tiles, those that are shared once.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::size_t bytes_behind(std::size_t number) const;
  void thin();

  Settings settings_;
  std::vector<Checkpoint> list_;  // by steps
  std::size_t bytes_ = 0;
  Clock::time_point last_ = Clock::now();
};

}  // namespace kerf::stock::replay
