#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

/// Points of a plane, which can be switched off: which one is nearest? A tree that halves the
/// points by their middle along the longer side, each node with its box and how many are on.
class NearTree {
 public:
  /// All are on.
  explicit NearTree(std::span<const Vec2> points);

  void switch_on(std::uint32_t point) { switch_to(point, true); }
  void switch_off(std::uint32_t point) { switch_to(point, false); }

  /// The nearest point that is on, of equal ones the first; kNone if none is.
  [[nodiscard]] std::uint32_t nearest(Vec2 at) const;
  /// The nearest `count` that are on, by ascending distance.
  void nearest(Vec2 at, std::size_t count, std::vector<std::uint32_t>& found) const;

 private:
  struct Node {
    Vec2 least;
    Vec2 most;
    std::uint32_t first = 0;  // of the places in order_
    std::uint32_t end = 0;
    std::uint32_t right = 0;  // the left one is the next; 0: a leaf
    std::uint32_t parent = kNone;
    std::uint32_t on = 0;  // how many
  };
  struct Hit {
    double square = 0;  // of the distance
    std::uint32_t point = kNone;
    friend bool operator<(const Hit& a, const Hit& b) {
      return a.square < b.square || (a.square == b.square && a.point < b.point);
    }
  };
  struct Search {
    Vec2 at;
    std::size_t count = 1;
    std::vector<Hit> hits{};  // ascending

    [[nodiscard]] bool wants(double square) const {
      return hits.size() < count || square <= hits.back().square;
    }
    void take(Hit hit);
  };

  std::uint32_t make(std::uint32_t first, std::uint32_t end, std::uint32_t parent);
  [[nodiscard]] Node boxed(std::uint32_t first, std::uint32_t end) const;
  void look(std::uint32_t node, Search& search) const;
  void look_at_points(const Node& leaf, Search& search) const;
  void switch_to(std::uint32_t point, bool on);

  std::span<const Vec2> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> leaf_;  // of each point
  std::vector<bool> is_on_;
  std::vector<Node> nodes_;
};

}  // namespace kerf::process::ordering
