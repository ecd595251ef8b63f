#include "job/live/owner_table.hpp"

#include <mutex>

namespace kerf::job {

void OwnerTable::add(std::uint32_t motion, const PartOwner& owner) {
  const std::unique_lock lock(mutex_);
  const auto [known, is_new] = known_.try_emplace(owner, static_cast<std::uint32_t>(rows_.size()));
  if (is_new) rows_.push_back(owner);
  while (rows_.size() > kMostNumbers << shift_) ++shift_;
  if (of_motion_.size() <= motion) of_motion_.resize(motion + 1);
  of_motion_[motion] = known->second + 1;
}

std::uint32_t OwnerTable::row_of(std::uint32_t motion) const {
  return motion < of_motion_.size() ? of_motion_[motion] : 0;
}

std::uint16_t OwnerTable::number(std::uint32_t motion) const {
  const std::shared_lock lock(mutex_);
  const std::uint32_t row = row_of(motion);
  return static_cast<std::uint16_t>(row == 0 ? 0U : 1U + ((row - 1) >> shift_));
}

PartOwner OwnerTable::owner(std::uint32_t motion) const {
  const std::shared_lock lock(mutex_);
  const std::uint32_t row = row_of(motion);
  return row == 0 ? PartOwner{} : rows_[row - 1];
}

std::uint32_t OwnerTable::edition() const {
  const std::shared_lock lock(mutex_);
  return shift_;
}

std::vector<PartOwner> OwnerTable::numbered(std::size_t from) const {
  const std::shared_lock lock(mutex_);
  std::vector<PartOwner> some;
  const std::size_t count = 1 + ((rows_.size() + (std::size_t{1} << shift_) - 1) >> shift_);
  for (std::size_t number = from; number < count; ++number)
    some.push_back(number == 0 ? PartOwner{} : rows_[(number - 1) << shift_]);
  return some;
}

std::size_t OwnerTable::bytes() const {
  const std::shared_lock lock(mutex_);
  constexpr std::size_t kNode = 64;  // of the map
  return rows_.size() * (sizeof(PartOwner) + kNode) + of_motion_.capacity() * sizeof(of_motion_[0]);
}

}  // namespace kerf::job
