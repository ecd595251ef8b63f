#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {
namespace {

// An item of more entries that lead elsewhere than they begin is one that cannot be made backwards.
constexpr std::size_t kMostPaired = 64;

std::uint32_t count_of(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// Place among `entries` of the one that leads back, kNone if none does.
std::uint32_t back_of(const std::vector<Entry>& entries, std::size_t which) {
  const Entry& entry = entries[which];
  if (entry.begin == entry.end) return count_of(which);
  if (entries.size() > kMostPaired) return kNone;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].begin == entry.end && entries[i].end == entry.begin) return count_of(i);
  }
  return kNone;
}

bool is_said(std::span<const Item> items, std::size_t item, std::uint32_t before) {
  return before < items.size() && before != item;
}

}  // namespace

Lists::Lists(std::span<const std::uint32_t> counts) : first_(counts.size() + 1) {
  for (std::size_t i = 0; i < counts.size(); ++i) first_[i + 1] = first_[i] + counts[i];
  next_.assign(first_.begin(), first_.end() - 1);
  values_.resize(first_.back());
}

FlatItems::FlatItems(std::span<const Item> items) {
  for (const Item& item : items) add_entries(item);
  link(items);
}

void FlatItems::add_entries(const Item& item) {
  const std::uint32_t first = first_.back();
  for (std::size_t i = 0; i < item.entries.size(); ++i) {
    const std::uint32_t back = back_of(item.entries, i);
    entries_.push_back(item.entries[i]);
    owner_.push_back(size());
    back_.push_back(back == kNone ? kNone : first + back);
    are_symmetric_ = are_symmetric_ && back != kNone;
  }
  first_.push_back(count_of(entries_.size()));
}

void FlatItems::link(std::span<const Item> items) {
  std::vector<std::uint32_t> before(items.size());
  std::vector<std::uint32_t> after(items.size());
  const auto each = [&](auto&& act) {
    for (std::uint32_t item = 0; item < items.size(); ++item) {
      for (const std::uint32_t other : items[item].before) {
        if (is_said(items, item, other)) act(item, other);
      }
    }
  };
  each([&](std::uint32_t item, std::uint32_t other) { ++before[item], ++after[other]; });
  before_ = Lists(before);
  after_ = Lists(after);
  each([&](std::uint32_t item, std::uint32_t other) {
    before_.add(item, other);
    after_.add(other, item);
  });
}

double travel_of(const FlatItems& items, const Ends& ends, std::span<const Turn> turns) {
  double sum = 0;
  Vec2 at = ends.from;
  for (const Turn& turn : turns) {
    const Entry& entry = items.entries()[items.first_entry(turn.item) + turn.entry];
    sum += apart(at, entry.begin);
    at = entry.end;
  }
  return ends.comes_back ? sum + apart(at, ends.to) : sum;
}

bool is_allowed(const FlatItems& items, std::span<const Turn> turns) {
  std::vector<bool> is_made(items.size());
  for (const Turn& turn : turns) {
    for (const std::uint32_t before : items.before(turn.item)) {
      if (!is_made[before]) return false;
    }
    is_made[turn.item] = true;
  }
  return true;
}

}  // namespace kerf::process::ordering
