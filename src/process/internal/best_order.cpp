#include "process/internal/best_order.hpp"

#include <algorithm>
#include <array>

namespace kerf::process::ordering {
namespace {

constexpr std::size_t kMostEntries = 5'000;
constexpr std::size_t kMostSteps = 60'000'000;  // a fifth of a second
constexpr double kRounding_mm = 1e-9;
constexpr double kNever = std::numeric_limits<double>::infinity();

using Set = std::uint32_t;  // of items, a bit each

/// Held and Karp's table over (items made, entry of the last one). What it takes at least from
/// there to the end is known from the same table over items alone, each gap the least between any
/// of their entries: where that is more than a way that is known, nobody needs to go on.
class BestOrder {
 public:
  BestOrder(const FlatItems& items, const Ends& ends, double known_mm)
      : items_(items),
        ends_(ends),
        known_mm_(known_mm + kRounding_mm),
        count_(items.size()),
        all_((1U << count_) - 1) {}

  std::optional<std::vector<Turn>> find() {
    find_least_gaps();
    find_rest();
    ways_.assign(std::size_t{all_ + 1} * entries().size(), kNever);
    from_.assign(ways_.size(), kNone);
    for (std::uint32_t item = 0; item < count_; ++item) {
      if (may_follow(0, item)) begin_with(item);
    }
    for (Set made = 1; made < all_; ++made) {
      if (!go_on_from(made)) return std::nullopt;
    }
    return read_back();
  }

 private:
  template <typename T>
  using Square = std::array<std::array<T, kMostExact>, kMostExact>;

  [[nodiscard]] const std::vector<Entry>& entries() const { return items_.entries(); }
  [[nodiscard]] static bool has(Set set, std::uint32_t item) { return (set >> item & 1U) != 0; }
  double& way_to(Set made, std::uint32_t entry) {
    return ways_[std::size_t{made} * entries().size() + entry];
  }
  std::uint32_t& from(Set made, std::uint32_t entry) {
    return from_[std::size_t{made} * entries().size() + entry];
  }
  [[nodiscard]] double way_home(std::uint32_t entry) const {
    return ends_.comes_back ? apart(entries()[entry].end, ends_.to) : 0;
  }

  [[nodiscard]] bool may_follow(Set made, std::uint32_t item) const {
    const auto before = items_.before(item);
    return !has(made, item) && std::all_of(before.begin(), before.end(),
                                           [&](std::uint32_t each) { return has(made, each); });
  }

  template <typename Act>
  void each_entry(std::uint32_t item, Act&& act) const {
    for (std::uint32_t e = items_.first_entry(item); e < items_.end_entry(item); ++e) act(e);
  }

  [[nodiscard]] double least_gap(std::uint32_t item, std::uint32_t next) const {
    double least = kNever;
    each_entry(item, [&](std::uint32_t a) {
      each_entry(next, [&](std::uint32_t b) {
        least = std::min(least, apart(entries()[a].end, entries()[b].begin));
      });
    });
    return least;
  }

  void find_least_gaps() {
    for (std::uint32_t a = 0; a < count_; ++a) {
      for (std::uint32_t b = 0; b < count_; ++b) gaps_[a][b] = a == b ? 0 : least_gap(a, b);
      home_[a] = kNever;
      each_entry(a, [&](std::uint32_t e) { home_[a] = std::min(home_[a], way_home(e)); });
    }
  }

  /// rest_[made][item]: at least this much from the end of `item`, the last one made.
  void find_rest() {
    rest_.resize(all_ + 1);
    for (Set made = all_; made > 0; --made) {
      for (std::uint32_t item = 0; item < count_; ++item) {
        double least = made == all_ ? home_[item] : kNever;
        for (std::uint32_t next = 0; next < count_; ++next) {
          if (has(made, next)) continue;
          least = std::min(least, gaps_[item][next] + rest_[made | 1U << next][next]);
        }
        rest_[made][item] = least;
      }
    }
  }

  void begin_with(std::uint32_t item) {
    each_entry(item, [&](std::uint32_t e) {
      reach(1U << item, e, apart(ends_.from, entries()[e].begin), kNone);
    });
  }

  void reach(Set made, std::uint32_t entry, double way, std::uint32_t last) {
    if (way >= way_to(made, entry)) return;
    if (way + rest_[made][items_.owner(entry)] > known_mm_) return;
    way_to(made, entry) = way;
    from(made, entry) = last;
  }

  /// False when there is too much to be looked at.
  bool go_on_from(Set made) {
    for (std::uint32_t last = 0; last < entries().size(); ++last) {
      const double way = way_to(made, last);
      if (way == kNever) continue;
      for (std::uint32_t item = 0; item < count_; ++item) {
        if (!may_follow(made, item)) continue;
        steps_ += items_.end_entry(item) - items_.first_entry(item);
        each_entry(item, [&](std::uint32_t e) {
          reach(made | 1U << item, e, way + apart(entries()[last].end, entries()[e].begin), last);
        });
      }
      if (steps_ > kMostSteps) return false;
    }
    return true;
  }

  std::optional<std::vector<Turn>> read_back() {
    double least = kNever;
    std::uint32_t last = kNone;
    for (std::uint32_t e = 0; e < entries().size(); ++e) {
      const double way = way_to(all_, e) + way_home(e);
      if (way < least) least = way, last = e;
    }
    if (last == kNone) return std::nullopt;
    std::vector<Turn> turns;
    for (Set made = all_; made != 0;) {
      const std::uint32_t item = items_.owner(last);
      turns.push_back({item, last - items_.first_entry(item)});
      last = from(made, last);
      made &= ~(1U << item);
    }
    std::reverse(turns.begin(), turns.end());
    return turns;
  }

  const FlatItems& items_;
  const Ends& ends_;
  double known_mm_;
  std::uint32_t count_;
  Set all_;
  Square<double> gaps_{};
  std::array<double, kMostExact> home_{};
  std::vector<std::array<double, kMostExact>> rest_;
  std::vector<double> ways_;
  std::vector<std::uint32_t> from_;
  std::size_t steps_ = 0;
};

}  // namespace

std::optional<std::vector<Turn>> best_order(const FlatItems& items, const Ends& ends,
                                            double known_mm) {
  if (items.size() == 0 || items.size() > kMostExact || items.entries().size() > kMostEntries)
    return std::nullopt;
  return BestOrder(items, ends, known_mm).find();
}

}  // namespace kerf::process::ordering
