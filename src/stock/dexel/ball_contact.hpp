#pragma once

#include <optional>
#include <span>

#include "stock/dexel/lattice.hpp"
#include "stock/dexel/tile.hpp"
#include "stock/sweep/ball_way.hpp"

namespace kerf::stock::dexel {

/// Where the ball of a probe touches what dexels show (stock.md §5, G31).
///
/// Between dexels the surface is that of their ends: each is a piece of a plane as large as its
/// cell, seen by the grid that looks at it most squarely. So a level face, and a wall along an
/// axis, is touched where it is, wherever the dexels stand; one that leans within a hundredth of a
/// cell, because normals are kept to a degree, and a round one within an eighth of the cell's
/// square over its radius. At a sharp edge the ball may stop up to a cell early.
class BallContact {
 public:
  /// The way counts from the middle of the stock.
  explicit BallContact(const BallWay& ball) : ball_(ball), box_(bounds(ball)) {}

  /// One tile of a grid; its first dexel is number `column`, `row` of the grid.
  void look_at(const Lattice& lattice, const Tile& tile, int column, int row);
  /// The first t in [0, 1] of all that was looked at; nullopt: at none.
  [[nodiscard]] const std::optional<double>& first() const { return first_; }

 private:
  /// A dexel and its cell.
  struct Line {
    int axis = 2;
    double b = 0;
    double c = 0;
    double half_b = 0;
    double half_c = 0;
  };

  [[nodiscard]] bool is_near(const Line& line) const;
  void look_at(const Line& line, std::span<const DexelEnd> ends);
  void look_at_face(const Line& line, const DexelEnd& end);
  void met_at(double t) {
    if (!first_ || t < *first_) first_ = t;
  }

  BallWay ball_;
  Bounds box_;
  std::optional<double> first_;
};

}  // namespace kerf::stock::dexel
