#include "stock/replay/recording.hpp"

#include <mutex>

namespace kerf::stock::replay {

Recording::Recording(Model& model, const Settings& settings)
    : settings_(settings),
      tiles_(tiles_of(model)),
      keeper_(*tiles_),
      checkpoints_({settings.memory_bytes / 2, settings.interval_s}) {
  checkpoints_.add({0, keeper_.look()});
}

void Recording::added(const Body& body) {
  const std::unique_lock lock(mutex_);
  bodies_.push_back(body);
}

void Recording::cut(std::span<const Sweep> sweeps) {
  if (is_full_) return;
  const std::unique_lock lock(mutex_);
  for (const Sweep& sweep : sweeps) log_.add(sweep);
  const std::size_t bytes = log_.bytes() + timeline_.bytes();
  is_full_ = bytes > settings_.memory_bytes / 2 || log_.size() + sweeps.size() >= SweepLog::kMost;
  if (checkpoints_.is_due(log_.size())) checkpoints_.add({log_.size(), keeper_.look()});
}

void Recording::tell(std::uint32_t motion, double start_s, double end_s) {
  const std::unique_lock lock(mutex_);
  const std::size_t first = told_;
  while (told_ < log_.size() && log_.motion(told_) <= motion) ++told_;
  if (told_ > first) timeline_.add(start_s, end_s, told_);
  if (told_ == first && !is_full_) timeline_.reach(end_s);
}

void Recording::finish(double time_s) {
  const std::unique_lock lock(mutex_);
  if (!is_full_) timeline_.reach(time_s);
}

double Recording::reached_s() const {
  const std::shared_lock lock(mutex_);
  return timeline_.reached_s();
}

Instant Recording::at(double time_s) const {
  const std::shared_lock lock(mutex_);
  return timeline_.at(time_s);
}

std::vector<Body> Recording::bodies(std::size_t from) const {
  const std::shared_lock lock(mutex_);
  return {bodies_.begin() + static_cast<std::ptrdiff_t>(std::min(from, bodies_.size())),
          bodies_.end()};
}

std::vector<Sweep> Recording::sweeps(std::size_t from, std::size_t to) const {
  const std::shared_lock lock(mutex_);
  std::vector<Sweep> some;
  some.reserve(to - from);
  for (std::size_t i = from; i < to; ++i) some.push_back(log_[i]);
  return some;
}

std::optional<Checkpoint> Recording::checkpoint(std::size_t steps) const {
  const std::shared_lock lock(mutex_);
  const Checkpoint* const found = checkpoints_.before(steps);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

std::size_t Recording::bytes() const {
  const std::shared_lock lock(mutex_);
  return log_.bytes() + timeline_.bytes() + checkpoints_.bytes();
}

}  // namespace kerf::stock::replay
