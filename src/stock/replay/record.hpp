#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "stock/replay/checkpoints.hpp"
#include "stock/replay/timeline.hpp"

namespace kerf::stock::replay {

/// When the steps were done that one thread does to something, with checkpoints of that: what
/// players go by. Questions come from any thread.
///
/// It keeps to its memory: checkpoints get half of it, and when steps and times need the other half
/// is_full() is true, and what comes behind does not count.
class Record {
 public:
  struct Settings {
    std::size_t memory_bytes = std::size_t{256} << 20U;
    double interval_s = 0.25;  ///< of computing, between checkpoints
  };
  /// Nothing has been done to the tiles, which are there until all is.
  Record(Tiles& tiles, const Settings& settings);

  /// So many steps are done by now; what keeping them needs.
  void done(std::size_t steps, std::size_t bytes);
  /// A motion with the steps before this one that were told by none before; s of the run, rising.
  void tell(std::size_t steps, double start_s, double end_s);
  /// Nothing comes any more. The tiles are not looked at from now on.
  void finish(double time_s);

  [[nodiscard]] bool is_full() const { return is_full_; }
  /// Up to here it can be shown, s of the run.
  [[nodiscard]] double reached_s() const;
  [[nodiscard]] Instant at(double time_s) const;
  [[nodiscard]] std::optional<Checkpoint> checkpoint(std::size_t steps) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  Settings settings_;
  Keeper keeper_;
  mutable std::mutex mutex_;  // of what follows
  std::size_t told_ = 0;
  std::size_t step_bytes_ = 0;
  Timeline timeline_;
  Checkpoints checkpoints_;
  std::atomic<bool> is_full_ = false;
};

}  // namespace kerf::stock::replay
