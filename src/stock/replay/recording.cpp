#include "stock/replay/recording.hpp"

#include <algorithm>
#include <mutex>

namespace kerf::stock::replay {

Recording::Recording(Model& model, const Record::Settings& settings)
    : tiles_(tiles_of(model)), record_(*tiles_, settings) {}

void Recording::added(const Body& body) {
  const std::unique_lock lock(mutex_);
  bodies_.push_back(body);
}

void Recording::cut(std::span<const Sweep> sweeps) {
  if (record_.is_full() || log_.size() + sweeps.size() > SweepLog::kMost) return;
  {
    const std::unique_lock lock(mutex_);
    for (const Sweep& sweep : sweeps) log_.add(sweep);
  }
  record_.done(log_.size(), log_.bytes());
}

void Recording::tell(std::uint32_t motion, double start_s, double end_s) {
  while (told_ < log_.size() && log_.motion(told_) <= motion) ++told_;
  record_.tell(told_, start_s, end_s);
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

}  // namespace kerf::stock::replay
