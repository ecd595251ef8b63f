#pragma once

#include "stock/dexel/lattice.hpp"
#include "stock/dexel/shape.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {

/// Lengths along the dexels of a tile, added up, mm.
struct CommonLengths {
  double shape_mm = 0;    ///< of a shape
  double part_mm = 0;     ///< of the part in it
  double longest_mm = 0;  ///< likewise, along one dexel
};

/// A shape and the dexels of one tile that lie in its box. The places of shapes are those of the
/// stock's frame, whose middle is `middle`.
class ShapeWork {
 public:
  /// `box` counts from the middle of the stock; the lattice outlives this.
  ShapeWork(const Lattice& lattice, const Bounds& box, int first_column, int first_row);

  [[nodiscard]] CommonLengths measure(const Tile& tile, const InsideOf& inside, Vec3 middle) const;
  /// The same, and the tile loses what the shape holds.
  CommonLengths take(Tile& tile, const InsideOf& inside, Vec3 middle) const;

 private:
  template <class Act>
  void each(const Tile& tile, const InsideOf& inside, Act&& act) const;

  const Lattice& lattice_;
  Bounds box_;
  int first_column_;
  int first_row_;
};

}  // namespace kerf::stock::dexel
