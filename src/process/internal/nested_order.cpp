#include "process/internal/nested_order.hpp"

#include <algorithm>

namespace kerf::process::ordering {
namespace {

/// How many items of a chain in which each must be made before the next one end in each; nothing
/// where they go in circles.
std::optional<std::vector<std::uint32_t>> heights_of(const FlatItems& items) {
  std::vector<std::uint32_t> heights(items.size(), 0);
  std::vector<std::uint32_t> awaited(items.size());
  std::vector<std::uint32_t> ready;
  for (std::uint32_t item = 0; item < items.size(); ++item) {
    awaited[item] = static_cast<std::uint32_t>(items.before(item).size());
    if (awaited[item] == 0) ready.push_back(item);
  }
  for (std::size_t i = 0; i < ready.size(); ++i) {
    for (const std::uint32_t later : items.after(ready[i])) {
      heights[later] = std::max(heights[later], heights[ready[i]] + 1);
      if (--awaited[later] == 0) ready.push_back(later);
    }
  }
  if (ready.size() < items.size()) return std::nullopt;
  return heights;
}

/// An item with all that is inside of it, as one that has one entry.
struct Part {
  std::vector<Turn> turns;
  Item outside;
};

class NestedOrder {
 public:
  NestedOrder(const FlatItems& items, Search search) : items_(items), search_(search) {}

  std::optional<std::vector<Turn>> find(const Ends& ends) {
    const auto heights = heights_of(items_);
    if (!heights) return std::nullopt;
    find_children(*heights);
    std::vector<Turn> turns = ordered(outer_, ends);
    if (!is_allowed(items_, turns)) return std::nullopt;
    return turns;
  }

 private:
  void find_children(const std::vector<std::uint32_t>& heights) {
    children_.resize(items_.size());
    const auto lower = [&](std::uint32_t a, std::uint32_t b) { return heights[a] < heights[b]; };
    for (std::uint32_t item = 0; item < items_.size(); ++item) {
      const auto later = items_.after(item);
      if (later.empty()) {
        outer_.push_back(item);
      } else {
        children_[*std::min_element(later.begin(), later.end(), lower)].push_back(item);
      }
    }
    // From the inside outwards, so that nothing has to call itself.
    std::vector<std::uint32_t> by_height(items_.size());
    for (std::uint32_t item = 0; item < items_.size(); ++item) by_height[item] = item;
    std::stable_sort(by_height.begin(), by_height.end(), lower);
    parts_.resize(items_.size());
    for (const std::uint32_t item : by_height) parts_[item] = part_of(item);
  }

  [[nodiscard]] std::span<const Entry> entries_of(std::uint32_t item) const {
    const std::uint32_t first = items_.first_entry(item);
    return {items_.entries().data() + first, items_.end_entry(item) - first};
  }

  Part part_of(std::uint32_t item) {
    const auto entries = entries_of(item);
    Part part;
    if (children_[item].empty()) {
      part.outside.entries.assign(entries.begin(), entries.end());
      return part;
    }
    const Vec2 from = entries.front().begin;
    part.turns = ordered(children_[item], {from, true, from});
    const Vec2 at = entry_of(part.turns.back()).end;
    const auto nearest = std::min_element(
        entries.begin(), entries.end(),
        [&](const Entry& a, const Entry& b) { return apart(at, a.begin) < apart(at, b.begin); });
    part.turns.push_back({item, static_cast<std::uint32_t>(nearest - entries.begin())});
    part.outside.entries = {{entry_of(part.turns.front()).begin, nearest->end}};
    return part;
  }

  [[nodiscard]] const Entry& entry_of(const Turn& turn) const {
    return items_.entries()[items_.first_entry(turn.item) + turn.entry];
  }

  /// Frees what the parts hold.
  std::vector<Turn> ordered(const std::vector<std::uint32_t>& members, const Ends& ends) {
    std::vector<Item> outsides;
    for (const std::uint32_t item : members) outsides.push_back(std::move(parts_[item].outside));
    std::vector<Turn> turns;
    for (const Turn& turn : search_(FlatItems(outsides), ends)) {
      const std::uint32_t item = members[turn.item];
      std::vector<Turn>& inside = parts_[item].turns;
      if (inside.empty()) turns.push_back({item, turn.entry});
      turns.insert(turns.end(), inside.begin(), inside.end());
      inside = {};
    }
    return turns;
  }

  const FlatItems& items_;
  Search search_;
  std::vector<std::uint32_t> outer_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<Part> parts_;
};

}  // namespace

std::optional<std::vector<Turn>> nested_order(const FlatItems& items, const Ends& ends,
                                              Search search) {
  return NestedOrder(items, search).find(ends);
}

}  // namespace kerf::process::ordering
