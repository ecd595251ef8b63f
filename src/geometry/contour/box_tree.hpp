#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/contour/box.hpp"

namespace kerf::contour {

/// Boxes that are found by where they are: a packed Hilbert R-tree. The boxes are put in the order
/// in which a Hilbert curve meets their middles; each 16 in a row are one node, and each 16 nodes.
/// Made once in n log n; a search costs log n and what it finds.
class BoxTree {
 public:
  static constexpr std::size_t kFan = 16;

  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(item) for every box that meets `box`, borders included.
  template <typename Visit>
  void search(const Box& box, Visit&& visit) const {
    walk([&](std::size_t, std::size_t, const Box& node) { return node.meets(box); },
         [&](std::size_t place) { visit(order_[place]); });
  }

  /// Calls visit(place) for every box that is admitted together with all nodes above it, by
  /// admits(level, number in the level, box). Level 0 are the boxes themselves, by place.
  template <typename Admits, typename Visit>
  void walk(Admits&& admits, Visit&& visit) const {
    if (order_.empty()) return;
    walk_node(levels_.size() - 1, 0, levels_.back().size(), admits, visit);
  }

  /// The item at each place of level 0.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  [[nodiscard]] std::size_t level_count() const { return levels_.size(); }
  [[nodiscard]] std::span<const Box> level(std::size_t number) const { return levels_[number]; }

 private:
  template <typename Admits, typename Visit>
  void walk_node(std::size_t level, std::size_t begin, std::size_t end, Admits& admits,
                 Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (!admits(level, i, levels_[level][i])) continue;
      if (level == 0) {
        visit(i);
      } else {
        walk_node(level - 1, i * kFan, std::min((i + 1) * kFan, levels_[level - 1].size()), admits,
                  visit);
      }
    }
  }

  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Box>> levels_;
};

}  // namespace kerf::contour
