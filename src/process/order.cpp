#include "process/order.hpp"

#include <algorithm>

#include "process/internal/best_order.hpp"
#include "process/internal/nearest_order.hpp"
#include "process/internal/nested_order.hpp"
#include "process/internal/tour_search.hpp"

namespace kerf::process {
namespace {

using namespace ordering;

constexpr std::uint32_t kFewest = 10;  // below, the exact order or one of a part's inside
constexpr std::size_t kLeastShakes = 300;
constexpr std::size_t kShakesOfItem = 2;
constexpr std::size_t kMostShakes = 50'000;

std::size_t shakes_for(std::uint32_t count) {
  if (count < kFewest) return 0;
  return std::clamp(kShakesOfItem * count, kLeastShakes, kMostShakes);
}

std::vector<Turn> as_listed(std::uint32_t count) {
  std::vector<Turn> turns(count);
  for (std::uint32_t item = 0; item < count; ++item) turns[item].item = item;
  return turns;
}

/// Shorter, or as it was.
std::vector<Turn> shortened(const FlatItems& items, const Ends& ends,
                            const std::vector<Turn>& turns) {
  Tour tour{items, ends, turns};
  const Neighbours neighbours{items};
  TourSearch search{tour, neighbours};
  search.settle();
  search.shake(shakes_for(items.size()));
  choose_entries(tour);
  return tour.turns();
}

/// Of parts that are independent of each other.
std::vector<Turn> short_order(const FlatItems& items, const Ends& ends) {
  return items.size() < 2 ? nearest_order(items, ends)
                          : shortened(items, ends, nearest_order(items, ends));
}

struct Candidate {
  std::vector<Turn> turns;
  double travel_mm = 0;
};

class BestOf {
 public:
  BestOf(const FlatItems& items, const Ends& ends) : items_(items), ends_(ends) {}

  void offer(std::vector<Turn> turns) {
    const double travel_mm = travel_of(items_, ends_, turns);
    if (!best_.turns.empty() && travel_mm >= best_.travel_mm) return;
    best_ = {std::move(turns), travel_mm};
  }
  [[nodiscard]] const Candidate& best() const { return best_; }

 private:
  const FlatItems& items_;
  const Ends& ends_;
  Candidate best_;
};

Candidate shortest(const FlatItems& items, const Ends& ends, std::vector<Turn> nearest) {
  BestOf found{items, ends};
  found.offer(std::move(nearest));
  std::vector<Turn> listed = as_listed(items.size());
  if (is_allowed(items, listed)) found.offer(std::move(listed));
  if (items.have_precedence()) {
    if (auto nested = nested_order(items, ends, short_order)) found.offer(std::move(*nested));
  }
  found.offer(shortened(items, ends, found.best().turns));
  if (auto best = best_order(items, ends, found.best().travel_mm)) found.offer(std::move(*best));
  return found.best();
}

}  // namespace

Order file_order(std::span<const Item> items, const Ends& ends) {
  const FlatItems flat{items};
  Order order;
  order.turns = as_listed(flat.size());
  order.travel_mm = order.travel_file_mm = travel_of(flat, ends, order.turns);
  order.travel_nearest_mm = travel_of(flat, ends, nearest_order(flat, ends));
  return order;
}

Order find_order(std::span<const Item> items, const Ends& ends) {
  if (items.empty()) return file_order(items, ends);
  const FlatItems flat{items};
  Order order;
  std::vector<Turn> nearest = nearest_order(flat, ends);
  order.travel_file_mm = travel_of(flat, ends, as_listed(flat.size()));
  order.travel_nearest_mm = travel_of(flat, ends, nearest);
  Candidate best = shortest(flat, ends, std::move(nearest));
  order.turns = std::move(best.turns);
  order.travel_mm = best.travel_mm;
  return order;
}

}  // namespace kerf::process
