#pragma once

#include <memory>
#include <shared_mutex>
#include <vector>

#include "stock/replay/record.hpp"
#include "stock/replay/sweep_log.hpp"
#include "stock/sweep/cut_watch.hpp"

namespace kerf::stock::replay {

/// What a model is given while one thread cuts it. That thread tells it; questions come from any.
class Recording final : public CutWatch {
 public:
  /// `model` has not been cut, and is there until the recording is over.
  Recording(Model& model, const Record::Settings& settings);

  void added(const Body& body) override;
  /// What comes when the record is full is not kept.
  void cut(std::span<const Sweep> sweeps) override;
  /// A motion whose sweeps have been cut, with its time, s of the run; they come in their order.
  void tell(std::uint32_t motion, double start_s, double end_s);
  void finish(double time_s) { record_.finish(time_s); }

  [[nodiscard]] const Record& record() const { return record_; }
  /// Bodies from this one on.
  [[nodiscard]] std::vector<Body> bodies(std::size_t from) const;
  [[nodiscard]] std::vector<Sweep> sweeps(std::size_t from, std::size_t to) const;

 private:
  std::unique_ptr<Tiles> tiles_;
  Record record_;
  mutable std::shared_mutex mutex_;  // of what follows
  std::vector<Body> bodies_;
  SweepLog log_;
  std::size_t told_ = 0;  // steps whose times are known
};

}  // namespace kerf::stock::replay
