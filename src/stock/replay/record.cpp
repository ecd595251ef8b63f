#include "stock/replay/record.hpp"

namespace kerf::stock::replay {

Record::Record(Tiles& tiles, const Settings& settings)
    : settings_(settings),
      keeper_(tiles),
      checkpoints_({settings.memory_bytes / 2, settings.interval_s}) {
  checkpoints_.add({0, keeper_.look()});
}

void Record::done(std::size_t steps, std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  step_bytes_ = bytes;
  is_full_ = is_full_ || bytes + timeline_.bytes() > settings_.memory_bytes / 2;
  if (checkpoints_.is_due(steps)) checkpoints_.add({steps, keeper_.look()});
}

void Record::tell(std::size_t steps, double start_s, double end_s) {
  const std::scoped_lock lock(mutex_);
  if (steps > told_) {
    timeline_.add(start_s, end_s, steps);
    told_ = steps;
  } else if (!is_full_) {
    timeline_.reach(end_s);
  }
}

void Record::finish(double time_s) {
  const std::scoped_lock lock(mutex_);
  if (!is_full_) timeline_.reach(time_s);
}

double Record::reached_s() const {
  const std::scoped_lock lock(mutex_);
  return timeline_.reached_s();
}

Instant Record::at(double time_s) const {
  const std::scoped_lock lock(mutex_);
  return timeline_.at(time_s);
}

std::optional<Checkpoint> Record::checkpoint(std::size_t steps) const {
  const std::scoped_lock lock(mutex_);
  const Checkpoint* const found = checkpoints_.before(steps);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

std::size_t Record::bytes() const {
  const std::scoped_lock lock(mutex_);
  return step_bytes_ + timeline_.bytes() + checkpoints_.bytes();
}

}  // namespace kerf::stock::replay
