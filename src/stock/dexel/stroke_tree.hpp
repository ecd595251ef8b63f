#pragma once

#include <cstddef>
#include <vector>

#include "stock/dexel/strokes.hpp"

namespace kerf::stock::dexel {

/// Strokes in their order, halved and halved again. Node 1 is all of them, nodes 2 n and 2 n + 1
/// are the halves of node n.
class StrokeTree {
 public:
  struct Node {
    Stroke chord;       ///< from where its first stroke begins to where its last one ends
    double off_mm = 0;  ///< all of its strokes are within that of the chord
    std::size_t strokes = 0;
  };

  /// Precondition: there are some.
  explicit StrokeTree(const std::vector<const Stroke*>& strokes);

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Node& node(std::size_t number) const { return nodes_[number]; }
  [[nodiscard]] bool is_stroke(std::size_t number) const { return number >= leaves_; }
  /// Which stroke, by its place in their order. Precondition: is_stroke().
  [[nodiscard]] std::size_t stroke(std::size_t number) const { return number - leaves_; }

 private:
  std::size_t leaves_;  // a power of two; those behind the last stroke are empty
  std::vector<Node> nodes_;
};

}  // namespace kerf::stock::dexel
