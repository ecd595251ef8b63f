#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "stock/dexel/glance.hpp"
#include "stock/dexel/lattice.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {

/// From where to where each dexel of a tile has material at all, side by side: what lists of ends
/// say with a jump for every dexel. Kept beside them while a tile is worked at.
class Hulls {
 public:
  static_assert(Lattice::kTile % Glance::kLines == 0);

  /// Of four dexels: low > high where there is nothing; bits of those that are in one piece.
  struct Four {
    Glance::Four low;
    Glance::Four high;
    unsigned single;
  };

  explicit Hulls(const Tile& tile) : tile_(tile) {}

  /// Those from a column on, which is a multiple of four.
  [[nodiscard]] const Four& four(int column, int row) {
    if (!rows_) look();
    return (*rows_)[place(column, row)];
  }
  /// A dexel was cut.
  void changed(std::size_t dexel) {
    if (rows_) look_at(dexel);
  }
  /// Any dexel was.
  void forget() { rows_.reset(); }

 private:
  static constexpr int kFours = Lattice::kTile / Glance::kLines;
  using Rows = std::array<Four, std::size_t{kFours} * Lattice::kTile>;

  [[nodiscard]] static std::size_t place(int column, int row) {
    return static_cast<std::size_t>(row * kFours + column / Glance::kLines);
  }
  void look();
  void look_at(std::size_t dexel);

  const Tile& tile_;
  std::unique_ptr<Rows> rows_;
};

}  // namespace kerf::stock::dexel
