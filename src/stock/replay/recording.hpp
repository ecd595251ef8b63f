#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <vector>

#include "stock/replay/checkpoints.hpp"
#include "stock/replay/sweep_log.hpp"
#include "stock/replay/timeline.hpp"
#include "stock/sweep/cut_watch.hpp"

namespace kerf::stock::replay {

/// What a model is given while one thread cuts it, with checkpoints of it: what players go by. The
/// thread that cuts tells it; questions come from any.
///
/// It keeps to its memory: checkpoints get half of it, and when sweeps and times need the other
/// half is_full() is true, and what comes behind is not kept.
class Recording final : public CutWatch {
 public:
  struct Settings {
    std::size_t memory_bytes = std::size_t{256} << 20U;
    double interval_s = 0.25;  ///< of computing, between checkpoints
  };
  /// `model` has not been cut, and is there until the recording is over.
  Recording(Model& model, const Settings& settings);

  void added(const Body& body) override;
  void cut(std::span<const Sweep> sweeps) override;
  /// A motion whose sweeps have been cut, with its time, s of the run; they come in their order.
  void tell(std::uint32_t motion, double start_s, double end_s);
  /// Nothing comes any more. The model is not looked at from now on.
  void finish(double time_s);

  [[nodiscard]] bool is_full() const { return is_full_; }
  /// Up to here it can be shown, s of the run.
  [[nodiscard]] double reached_s() const;
  [[nodiscard]] Instant at(double time_s) const;
  /// Bodies from this one on.
  [[nodiscard]] std::vector<Body> bodies(std::size_t from) const;
  [[nodiscard]] std::vector<Sweep> sweeps(std::size_t from, std::size_t to) const;
  [[nodiscard]] std::optional<Checkpoint> checkpoint(std::size_t steps) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  Settings settings_;
  std::unique_ptr<Tiles> tiles_;
  Keeper keeper_;
  mutable std::shared_mutex mutex_;  // of what follows
  std::vector<Body> bodies_;
  SweepLog log_;
  std::size_t told_ = 0;  // steps whose times are known
  Timeline timeline_;
  Checkpoints checkpoints_;
  std::atomic<bool> is_full_ = false;
};

}  // namespace kerf::stock::replay
