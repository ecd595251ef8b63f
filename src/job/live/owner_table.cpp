#include "job/live/owner_table.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace kerf::job {

void OwnerTable::add(std::uint32_t motion, const PartOwner& owner, double engagement_deg) {
  const std::unique_lock lock(mutex_);
  const auto [known, is_new] = known_.try_emplace(owner, static_cast<std::uint32_t>(rows_.size()));
  if (is_new) rows_.push_back(owner);
  while (rows_.size() > kMostNumbers << shift_) share_more();
  take(known->second, engagement_deg);
  if (of_motion_.size() <= motion) of_motion_.resize(motion + 1);
  of_motion_[motion] = known->second + 1;
}

void OwnerTable::take(std::uint32_t row, double engagement_deg) {
  constexpr double kSteps = 10;  // of a degree: what is less is not told anew
  const std::size_t at = row >> shift_;
  if (at == numbered_.size()) numbered_.push_back({{rows_[row], 0}, ++changes_});
  Numbered& one = numbered_[at];
  const double rounded = std::round(kSteps * engagement_deg) / kSteps;
  if (!(rounded > one.row.engagement_deg)) return;
  one.row.engagement_deg = rounded;
  one.change = ++changes_;
}

void OwnerTable::share_more() {
  ++shift_;
  const std::size_t count = (numbered_.size() + 1) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    Numbered both = numbered_[2 * i];
    if (2 * i + 1 < numbered_.size()) {
      const Numbered& other = numbered_[2 * i + 1];
      both.row.engagement_deg = std::max(both.row.engagement_deg, other.row.engagement_deg);
    }
    numbered_[i] = both;
  }
  numbered_.resize(count);
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

OwnerTable::News OwnerTable::since(std::uint64_t change) const {
  const std::shared_lock lock(mutex_);
  News news{.first = 0, .rows = {}, .change = changes_};
  if (change == changes_) return news;
  const auto is_new = [&](const Numbered& one) { return one.change > change; };
  const auto first = std::find_if(numbered_.begin(), numbered_.end(), is_new);
  const auto last = std::find_if(numbered_.rbegin(), numbered_.rend(), is_new).base();
  if (change == 0) {
    news.rows.emplace_back();
  } else {
    news.first = static_cast<std::size_t>(first - numbered_.begin()) + 1;
  }
  for (auto one = first; one < last; ++one) news.rows.push_back(one->row);
  return news;
}

std::size_t OwnerTable::bytes() const {
  const std::shared_lock lock(mutex_);
  constexpr std::size_t kNode = 64;  // of the map
  return rows_.size() * (sizeof(PartOwner) + kNode) +
         of_motion_.capacity() * sizeof(of_motion_[0]) + numbered_.capacity() * sizeof(Numbered);
}

}  // namespace kerf::job
