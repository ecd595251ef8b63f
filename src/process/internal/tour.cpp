#include "process/internal/tour.hpp"

#include <algorithm>

namespace kerf::process::ordering {
namespace {

constexpr std::size_t kMostPairs = 20'000'000;  // of entries side by side
constexpr int kSweeps = 3;

std::uint32_t entries_at(const Tour& tour, std::uint32_t place) {
  const std::uint32_t item = tour[place].item;
  return tour.items().end_entry(item) - tour.items().first_entry(item);
}

bool can_be_compared(const Tour& tour) {
  std::size_t pairs = 0;
  for (std::uint32_t place = 2; place <= tour.size() && pairs <= kMostPairs; ++place)
    pairs += std::size_t{entries_at(tour, place)} * entries_at(tour, place - 1);
  return pairs <= kMostPairs;
}

/// The least way to each entry of a place, by which entry of the place before.
struct Reached {
  std::uint32_t first = 0;  // entry of the item
  std::vector<double> ways;
  std::vector<std::uint32_t> from;
};

Reached reached_from_start(const Tour& tour) {
  const FlatItems& items = tour.items();
  Reached here{items.first_entry(tour[1].item), {}, {}};
  for (std::uint32_t i = 0; i < entries_at(tour, 1); ++i) {
    here.ways.push_back(apart(tour[0].end, items.entries()[here.first + i].begin));
    here.from.push_back(kNone);
  }
  return here;
}

Reached reached_from(const Reached& last, const Tour& tour, std::uint32_t place) {
  const std::vector<Entry>& entries = tour.items().entries();
  Reached here{tour.items().first_entry(tour[place].item), {}, {}};
  for (std::uint32_t i = 0; i < entries_at(tour, place); ++i) {
    double best = std::numeric_limits<double>::infinity();
    std::uint32_t from = kNone;
    for (std::uint32_t k = 0; k < last.ways.size(); ++k) {
      const double way =
          last.ways[k] + apart(entries[last.first + k].end, entries[here.first + i].begin);
      if (way < best) best = way, from = k;
    }
    here.ways.push_back(best);
    here.from.push_back(from);
  }
  return here;
}

std::uint32_t best_last(const Reached& last, const Tour& tour) {
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t which = 0;
  for (std::uint32_t k = 0; k < last.ways.size(); ++k) {
    const Vec2 end = tour.items().entries()[last.first + k].end;
    const double way = last.ways[k] + tour.way(end, tour.size() + 1);
    if (way < best) best = way, which = k;
  }
  return which;
}

void choose_best(Tour& tour) {
  std::vector<Reached> table{reached_from_start(tour)};
  for (std::uint32_t place = 2; place <= tour.size(); ++place)
    table.push_back(reached_from(table.back(), tour, place));
  std::uint32_t which = best_last(table.back(), tour);
  for (std::uint32_t place = tour.size(); place >= 1; --place) {
    const Reached& here = table[place - 1];
    tour.enter(place, here.first + which);
    which = here.from[which];
  }
}

void choose_for_neighbours(Tour& tour, std::uint32_t place) {
  const FlatItems& items = tour.items();
  const auto way = [&](std::uint32_t entry) {
    return apart(tour[place - 1].end, items.entries()[entry].begin) +
           tour.way(items.entries()[entry].end, place + 1);
  };
  const std::uint32_t item = tour[place].item;
  std::uint32_t best = tour[place].entry;
  double least = way(best);
  for (std::uint32_t entry = items.first_entry(item); entry < items.end_entry(item); ++entry) {
    const double here = way(entry);
    if (here < least) least = here, best = entry;
  }
  tour.enter(place, best);
}

}  // namespace

Tour::Tour(const FlatItems& items, const Ends& ends, std::span<const Turn> turns)
    : items_(items), comes_back_(ends.comes_back), places_(items.size()) {
  stops_.reserve(turns.size() + 2);
  stops_.push_back({ends.from, ends.from});
  for (const Turn& turn : turns) {
    const std::uint32_t entry = items.first_entry(turn.item) + turn.entry;
    const Entry& way = items.entries()[entry];
    places_[turn.item] = static_cast<std::uint32_t>(stops_.size());
    stops_.push_back({way.begin, way.end, turn.item, entry});
  }
  stops_.push_back({ends.to, ends.to});
}

Stop Tour::turned(std::uint32_t place) const {
  Stop stop = stops_[place];
  const std::uint32_t back = items_.back(stop.entry);
  if (back == kNone) return stop;
  const Entry& way = items_.entries()[back];
  return {way.begin, way.end, stop.item, back};
}

double Tour::travel() const {
  double sum = 0;
  for (std::uint32_t place = 0; place <= size(); ++place) sum += gap(place);
  return sum;
}

std::vector<Turn> Tour::turns() const {
  std::vector<Turn> turns;
  turns.reserve(size());
  for (std::uint32_t place = 1; place <= size(); ++place) {
    const Stop& stop = stops_[place];
    turns.push_back({stop.item, stop.entry - items_.first_entry(stop.item)});
  }
  return turns;
}

void Tour::make_reversed(std::uint32_t first, std::uint32_t last) {
  while (first < last) {
    const Stop behind = turned(first);
    stops_[first] = turned(last);
    stops_[last] = behind;
    places_[stops_[first].item] = first;
    places_[behind.item] = last;
    ++first;
    --last;
  }
  if (first == last) stops_[first] = turned(first);
}

void Tour::make_swapped(std::uint32_t first, std::uint32_t middle, std::uint32_t end) {
  std::rotate(stops_.begin() + first, stops_.begin() + middle, stops_.begin() + end);
  for (std::uint32_t place = first; place < end; ++place) places_[stops_[place].item] = place;
}

void Tour::make_entered(std::uint32_t place, std::uint32_t entry) {
  const Entry& way = items_.entries()[entry];
  stops_[place] = {way.begin, way.end, stops_[place].item, entry};
}

void Tour::reverse(std::uint32_t first, std::uint32_t last) {
  note({Change::Kind::reversed, first, 0, last});
  make_reversed(first, last);
}

void Tour::swap(std::uint32_t first, std::uint32_t middle, std::uint32_t end) {
  note({Change::Kind::swapped, first, middle, end});
  make_swapped(first, middle, end);
}

void Tour::enter(std::uint32_t place, std::uint32_t entry) {
  note({Change::Kind::entered, place, stops_[place].entry, 0});
  make_entered(place, entry);
}

void Tour::mark() {
  is_marked_ = true;
  changes_.clear();
}

void Tour::take_back(const Change& change) {
  switch (change.kind) {
    case Change::Kind::reversed: return make_reversed(change.first, change.end);
    case Change::Kind::swapped:
      return make_swapped(change.first, change.first + (change.end - change.middle), change.end);
    case Change::Kind::entered: return make_entered(change.first, change.middle);
  }
}

void Tour::back_to_mark() {
  for (; !changes_.empty(); changes_.pop_back()) take_back(changes_.back());
}

void choose_entries(Tour& tour) {
  if (tour.size() == 0) return;
  if (can_be_compared(tour)) return choose_best(tour);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::uint32_t place = 1; place <= tour.size(); ++place) choose_for_neighbours(tour, place);
  }
}

}  // namespace kerf::process::ordering
