#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "stock/sweep/way.hpp"

namespace kerf::stock::compare {

/// Things in space that are found by how near they are: a binary tree of boxes, halved along the
/// longest side of what the middles of the things take up. Made in n log n; a search costs about
/// log n and what is nearly as near. The same things make the same tree, whatever the threads.
class NearTree {
  struct Part;

 public:
  /// Floats, rounded outwards.
  struct Box {
    std::array<float, 3> low;
    std::array<float, 3> high;

    /// From what of a box is nearest.
    [[nodiscard]] double square_from(const Bounds& other) const {
      const double x = std::max(double{low[0]} - other.high.x, other.low.x - double{high[0]});
      const double y = std::max(double{low[1]} - other.high.y, other.low.y - double{high[1]});
      const double z = std::max(double{low[2]} - other.high.z, other.low.z - double{high[2]});
      const auto square = [](double out) { return out > 0 ? out * out : 0; };
      return square(x) + square(y) + square(z);
    }
    [[nodiscard]] double square_from(Vec3 place) const {
      const double x = outside(place.x, low[0], high[0]);
      const double y = outside(place.y, low[1], high[1]);
      const double z = outside(place.z, low[2], high[2]);
      return x * x + y * y + z * z;
    }

   private:
    [[nodiscard]] static double outside(double at, float from, float to) {
      const double below = double{from} - at;
      const double above = at - double{to};
      const double out = below > above ? below : above;
      return out > 0 ? out : 0;
    }
  };

  /// The leaves that are near a box, of all whose places a search may begin there instead of at the
  /// root. Nothing depends on it but speed.
  class Start;

  static constexpr std::size_t kLeaf = 4;  ///< things in a leaf
  static constexpr std::size_t kBytesOfThing = sizeof(std::uint32_t) + 2 * sizeof(Box) / kLeaf;
  NearTree() = default;
  /// `box_of(i)` for i below `count` < 2^31.
  NearTree(std::size_t count, const std::function<Bounds(std::size_t)>& box_of);

  /// Calls look(thing, square) for things whose boxes are nearer than `square` mm², which look()
  /// may make smaller, the nearer boxes first.
  template <class Look>
  void search(Vec3 place, double& square, Look&& look) const {
    const Part root = whole();
    search_from({&root, 1}, place, square, look);
  }
  /// The same from a start that serves.
  template <class Look>
  void search(const Start& start, Vec3 place, double& square, Look&& look) const;

  /// Calls look(thing) for things in boxes that admits(box).
  template <class Admits, class Look>
  void walk(Admits&& admits, Look&& look) const;
  /// The same, of boxes that meet that of a start.
  template <class Admits, class Look>
  void walk(const Start& start, Admits&& admits, Look&& look) const;

  /// For places in a box, and what is no farther from it than `reach_mm`.
  void begin(const Bounds& box, double reach_mm, Start& start) const;

  [[nodiscard]] std::size_t bytes() const {
    return order_.size() * sizeof(order_[0]) + boxes_.size() * sizeof(Box);
  }

 private:
  // A node of n things has ceil(n / kLeaf) leaves, so 2 of these - 1 nodes: itself, those of its
  // first half, those of the second.
  struct Part {
    std::uint32_t node;
    std::uint32_t begin;
    std::uint32_t count;
    double square;

    [[nodiscard]] bool is_leaf() const { return count <= kLeaf; }
    [[nodiscard]] Part first() const {
      return {node + 1, begin, static_cast<std::uint32_t>((leaves() + 1) / 2 * kLeaf), 0};
    }
    [[nodiscard]] Part second() const {
      const Part one = first();
      return {node + static_cast<std::uint32_t>(2 * one.leaves()), begin + one.count,
              count - one.count, 0};
    }
    [[nodiscard]] std::size_t leaves() const { return (count + kLeaf - 1) / kLeaf; }
  };
  static constexpr std::size_t kDeepest = 64;
  struct Middles;

  void build(const Part& part, const Middles& middles,
             const std::function<Bounds(std::size_t)>& box_of);
  template <class Look>
  void search_from(std::span<const Part> from, Vec3 place, double& square, Look&& look) const;
  template <class Admits, class Look>
  void walk_from(const Part& from, Admits&& admits, Look&& look) const;
  [[nodiscard]] Part whole() const { return {0, 0, static_cast<std::uint32_t>(order_.size()), 0}; }

  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

class NearTree::Start {
 public:
  Start() = default;  ///< serves nowhere
  /// A place in the box, from which something that is looked for is no farther.
  [[nodiscard]] bool serves(Vec3 place, double square) const {
    return square <= square_ && place.x >= box_.low.x && place.x <= box_.high.x &&
           place.y >= box_.low.y && place.y <= box_.high.y && place.z >= box_.low.z &&
           place.z <= box_.high.z;
  }

 private:
  friend class NearTree;
  static constexpr std::size_t kMost = 24;  // of more leaves the root is as good

  Bounds box_;
  double square_ = -1;
  std::array<Part, kMost> parts_;  // those from count_ on are nothing
  std::size_t count_ = 0;
};

template <class Look>
void NearTree::search(const Start& start, Vec3 place, double& square, Look&& look) const {
  search_from({start.parts_.data(), start.count_}, place, square, look);
}

template <class Look>
void NearTree::search_from(std::span<const Part> from, Vec3 place, double& square,
                           Look&& look) const {
  if (order_.empty()) return;
  std::array<Part, kDeepest + Start::kMost> waiting;
  std::size_t count = 0;
  for (Part part : from) {
    part.square = boxes_[part.node].square_from(place);
    if (part.square > square) continue;
    waiting[count++] = part;
    if (count > 1 && waiting[0].square < part.square) std::swap(waiting[0], waiting[count - 1]);
  }
  while (count > 0) {
    const Part part = waiting[--count];
    if (part.square > square) continue;
    if (part.is_leaf()) {
      for (std::uint32_t i = 0; i < part.count; ++i) look(order_[part.begin + i], square);
      continue;
    }
    Part near = part.first();
    Part far = part.second();
    near.square = boxes_[near.node].square_from(place);
    far.square = boxes_[far.node].square_from(place);
    if (far.square < near.square) std::swap(near, far);
    if (far.square <= square) waiting[count++] = far;
    if (near.square <= square) waiting[count++] = near;
  }
}

template <class Admits, class Look>
void NearTree::walk(Admits&& admits, Look&& look) const {
  if (!order_.empty()) walk_from(whole(), admits, look);
}

template <class Admits, class Look>
void NearTree::walk(const Start& start, Admits&& admits, Look&& look) const {
  for (std::size_t i = 0; i < start.count_; ++i) walk_from(start.parts_[i], admits, look);
}

template <class Admits, class Look>
void NearTree::walk_from(const Part& from, Admits&& admits, Look&& look) const {
  std::array<Part, kDeepest> waiting;
  std::size_t count = 1;
  waiting[0] = from;
  while (count > 0) {
    const Part part = waiting[--count];
    if (!admits(boxes_[part.node])) continue;
    if (part.is_leaf()) {
      for (std::uint32_t i = 0; i < part.count; ++i) look(order_[part.begin + i]);
    } else {
      waiting[count++] = part.second();
      waiting[count++] = part.first();
    }
  }
}

}  // namespace kerf::stock::compare
