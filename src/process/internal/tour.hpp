#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

/// Where an item is begun and where it ends, at its place in the tour.
struct Stop {
  Vec2 begin;
  Vec2 end;
  std::uint32_t item = kNone;
  std::uint32_t entry = kNone;  ///< of all entries
};

/// An order of all items as it is being changed. Places 1 to size() are the items, in front of them
/// and behind them the ends of the way. Changes can be taken back.
class Tour {
 public:
  /// Precondition: `turns` has each item once; what `items` looks at outlives the tour.
  Tour(const FlatItems& items, const Ends& ends, std::span<const Turn> turns);

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(stops_.size() - 2); }
  [[nodiscard]] const FlatItems& items() const { return items_; }
  [[nodiscard]] const Stop& operator[](std::uint32_t place) const { return stops_[place]; }
  [[nodiscard]] std::uint32_t place(std::uint32_t item) const { return places_[item]; }

  /// From `at` to the beginning of a place; nothing to an end that is not gone to.
  [[nodiscard]] double way(Vec2 at, std::uint32_t place) const {
    return place > size() && !comes_back_ ? 0 : apart(at, stops_[place].begin);
  }
  /// From the end of a place to the beginning of the next.
  [[nodiscard]] double gap(std::uint32_t place) const { return way(stops_[place].end, place + 1); }
  /// The stop as it is in a stretch that is made backwards: the item itself backwards, too, if it
  /// can be.
  [[nodiscard]] Stop turned(std::uint32_t place) const;
  [[nodiscard]] double travel() const;
  [[nodiscard]] std::vector<Turn> turns() const;

  /// Both included.
  void reverse(std::uint32_t first, std::uint32_t last);
  /// [middle, end) comes before [first, middle).
  void swap(std::uint32_t first, std::uint32_t middle, std::uint32_t end);
  void enter(std::uint32_t place, std::uint32_t entry);

  /// From here on changes are kept in mind.
  void mark();
  /// As it was at the last mark().
  void back_to_mark();

 private:
  struct Change {
    enum class Kind : std::uint8_t { reversed, swapped, entered } kind;
    std::uint32_t first, middle, end;
  };

  void make_reversed(std::uint32_t first, std::uint32_t last);
  void make_swapped(std::uint32_t first, std::uint32_t middle, std::uint32_t end);
  void make_entered(std::uint32_t place, std::uint32_t entry);
  void take_back(const Change& change);
  void note(const Change& change) {
    if (is_marked_) changes_.push_back(change);
  }

  const FlatItems& items_;
  bool comes_back_;
  std::vector<Stop> stops_;
  std::vector<std::uint32_t> places_;
  std::vector<Change> changes_;
  bool is_marked_ = false;
};

/// Chooses the entries of the order as it is: the best ones there are, where they are not too many
/// to be compared, else each the best for what is beside it.
void choose_entries(Tour& tour);

}  // namespace kerf::process::ordering
