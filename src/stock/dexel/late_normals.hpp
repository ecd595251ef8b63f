#pragma once

#include <vector>

#include "stock/dexel/tile_window.hpp"

namespace kerf::stock::dexel {

/// Normals of the ends of a tile, computed when it is done: most ends are cut again before, and
/// need none. Until then DexelEnd::spare is the number of the cut that left an end.
class LateNormals {
 public:
  /// Both outlive this.
  LateNormals(const TilePlace& place, Tile& tile) : place_(place), tile_(tile) {}

  /// Ends from now on are of this cut; its number, not 0. Those named stay until settle().
  [[nodiscard]] std::uint16_t begin(const Frame& frame, const PosedSolid& solid,
                                    const Stroke& stroke);
  /// So many cuts may begin without those before being settled.
  void reserve(std::size_t cuts) {
    if (cuts_.size() + cuts > kMostCuts) settle();
  }
  /// That cut has left ends in a block.
  void note(int column, int row);
  /// All ends get their normals.
  void settle();

 private:
  struct Cut {
    const Frame* frame;
    const PosedSolid* solid;
    const Stroke* stroke;
  };
  static constexpr std::size_t kMostCuts = 65535;

  void settle_block(int column, int row);
  [[nodiscard]] DexelEnd settled(DexelEnd end, double b, double c, bool begins) const;

  TilePlace place_;
  Tile& tile_;
  std::vector<Cut> cuts_;
  bool has_left_ends_ = true;      ///< the last of them
  std::vector<std::size_t> open_;  ///< blocks that were cut, by their first dexels
  std::vector<bool> is_open_;      ///< of all dexels
};

}  // namespace kerf::stock::dexel
