#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "geometry/contour/box_tree.hpp"
#include "geometry/contour/internal/piece.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {

/// Pieces by where they are. Of long pieces that stand close beside each other at an angle, as the
/// teeth of a comb or the spikes of a star, the boxes lie over each other: so each node also has
/// the strip, along its longest piece, that holds all of it.
class PieceTree {
 public:
  /// The pieces stay the caller's and must live as long.
  explicit PieceTree(std::span<const Piece> pieces);

  /// Calls visit(a, b) once, with numbers of pieces, for each two that may be near to each other.
  template <typename Visit>
  void each_pair(Visit&& visit) const {
    each_pair_while([&](std::uint32_t a, std::uint32_t b) {
      visit(a, b);
      return true;
    });
  }
  /// The same until visit(a, b) is false.
  template <typename Visit>
  void each_pair_while(Visit&& visit) const {
    const auto order = tree_.order();
    bool goes_on = true;
    for (std::size_t place = 0; place < order.size() && goes_on; ++place) {
      const std::uint32_t mine = order[place];
      near_piece(place, pieces_[mine],
                 [&](std::uint32_t other) { goes_on = goes_on && visit(mine, other); });
    }
  }

  /// Calls visit(a) for each piece whose box is no farther than kSame_mm from the point.
  template <typename Visit>
  void near_point(Vec2 point, Visit&& visit) const {
    Box box;
    box.take(point);
    tree_.search(box.grown(kSame_mm), visit);
  }

 private:
  struct Strip {
    Vec2 across;  ///< unit length
    double low = 0;
    double high = 0;
  };

  // The pieces behind `place` in the order of the tree that may be near to this one.
  template <typename Visit>
  void near_piece(std::size_t place, const Piece& piece, Visit&& visit) const {
    const Box box = piece.box().grown(2 * kSame_mm);
    const double reach = std::fabs(piece.apex()) + 2 * kSame_mm;
    const auto admits = [&](std::size_t level, std::size_t number, const Box& node) {
      if (!node.meets(box)) return false;
      if (level == 0) return number > place;
      return last_place(level, number) > place && meets(strips_[level][number], piece, reach);
    };
    tree_.walk(admits, [&](std::size_t found) { visit(tree_.order()[found]); });
  }

  static std::size_t last_place(std::size_t level, std::size_t number) {
    std::size_t end = number + 1;
    for (; level > 0; --level) end *= BoxTree::kFan;
    return end - 1;
  }

  static bool meets(const Strip& strip, const Piece& piece, double reach) {
    const double from = dot(strip.across, piece.from);
    const double to = dot(strip.across, piece.to);
    return std::min(from, to) - reach <= strip.high && std::max(from, to) + reach >= strip.low;
  }

  [[nodiscard]] Strip strip_of(std::size_t begin, std::size_t end) const;

  std::span<const Piece> pieces_;
  BoxTree tree_;
  std::vector<std::vector<Strip>> strips_;  ///< by level; level 0 has none
};

}  // namespace kerf::contour
