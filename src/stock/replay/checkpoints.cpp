#include "stock/replay/checkpoints.hpp"

#include <algorithm>

namespace kerf::stock::replay {

bool Checkpoints::is_due(std::size_t steps) const {
  if (list_.empty()) return true;
  const std::chrono::duration<double> passed = Clock::now() - last_;
  return steps > list_.back().steps && passed.count() >= settings_.interval_s;
}

void Checkpoints::add(Checkpoint checkpoint) {
  list_.push_back(std::move(checkpoint));
  bytes_ += bytes_behind(list_.size() - 1);
  while (bytes_ > settings_.memory_bytes && list_.size() > 2) thin();
  last_ = Clock::now();
}

/// What a checkpoint has that the one before it has not.
std::size_t Checkpoints::bytes_behind(std::size_t number) const {
  const Moment& moment = list_[number].moment;
  std::size_t bytes = sizeof(Checkpoint) + moment.tiles.capacity() * sizeof(Kept);
  for (std::size_t i = 0; i < moment.tiles.size(); ++i) {
    if (number == 0 || list_[number - 1].moment.tiles[i] != moment.tiles[i])
      bytes += moment.tiles[i]->bytes();
  }
  return bytes;
}

// The first one stays, or times before the next one could not be gone to.
void Checkpoints::thin() {
  std::size_t left = 1;
  for (std::size_t i = 2; i < list_.size(); i += 2) list_[left++] = std::move(list_[i]);
  list_.resize(left);
  settings_.interval_s *= 2;
  bytes_ = 0;
  for (std::size_t i = 0; i < left; ++i) bytes_ += bytes_behind(i);
}

const Checkpoint* Checkpoints::before(std::size_t steps) const {
  const auto next = std::upper_bound(
      list_.begin(), list_.end(), steps,
      [](std::size_t wanted, const Checkpoint& one) { return wanted < one.steps; });
  return next == list_.begin() ? nullptr : &*std::prev(next);
}

}  // namespace kerf::stock::replay
