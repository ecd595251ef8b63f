#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "process/order.hpp"

namespace kerf::process::ordering {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// As geometry::length, but by the square root alone, which is exact and quick: it is asked for
/// some hundred million times.
inline double apart(Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  return std::sqrt(way.u * way.u + way.v * way.v);
}

/// Lists of numbers, one behind the other.
class Lists {
 public:
  /// Precondition: `counts` has the length of each list.
  explicit Lists(std::span<const std::uint32_t> counts);
  Lists() : Lists(std::span<const std::uint32_t>{}) {}

  void add(std::size_t list, std::uint32_t value) { values_[next_[list]++] = value; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t list) const {
    return {values_.data() + first_[list], first_[list + 1] - first_[list]};
  }
  [[nodiscard]] bool are_empty() const { return values_.empty(); }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::size_t> next_;
  std::vector<std::uint32_t> values_;
};

/// Items as the search wants them: all entries in one list, what must be made before and after.
class FlatItems {
 public:
  explicit FlatItems(std::span<const Item> items);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(first_.size() - 1); }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] std::uint32_t first_entry(std::uint32_t item) const { return first_[item]; }
  [[nodiscard]] std::uint32_t end_entry(std::uint32_t item) const { return first_[item + 1]; }
  [[nodiscard]] std::uint32_t owner(std::uint32_t entry) const { return owner_[entry]; }
  /// The entry whose way is that of `entry` from its end; kNone where there is none.
  [[nodiscard]] std::uint32_t back(std::uint32_t entry) const { return back_[entry]; }
  /// Every entry has one: a stretch that is made backwards is as long as forwards.
  [[nodiscard]] bool are_symmetric() const { return are_symmetric_; }

  [[nodiscard]] bool have_precedence() const { return !before_.are_empty(); }
  [[nodiscard]] std::span<const std::uint32_t> before(std::uint32_t item) const {
    return before_[item];
  }
  [[nodiscard]] std::span<const std::uint32_t> after(std::uint32_t item) const {
    return after_[item];
  }

 private:
  void add_entries(const Item& item);
  void link(std::span<const Item> items);

  std::vector<std::uint32_t> first_{0};
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> owner_;
  std::vector<std::uint32_t> back_;
  Lists before_;
  Lists after_;
  bool are_symmetric_ = true;
};

/// The way from end to end of `turns`, whose entries are counted from the first of their item.
[[nodiscard]] double travel_of(const FlatItems& items, const Ends& ends,
                               std::span<const Turn> turns);
[[nodiscard]] bool is_allowed(const FlatItems& items, std::span<const Turn> turns);

}  // namespace kerf::process::ordering
