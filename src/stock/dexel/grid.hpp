#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stock/dexel/dexel_ends.hpp"
#include "stock/dexel/lattice.hpp"
#include "stock/dexel/tile.hpp"
#include "stock/dexel/tile_work.hpp"
#include "stock/sweep/stretch.hpp"

namespace kerf::stock::dexel {

/// The dexels of one direction, tile by tile.
struct Grid {
  Lattice lattice;
  std::vector<Tile> tiles;

  /// mm³ of material.
  [[nodiscard]] double volume() const {
    double sum = 0;
    for (const Tile& tile : tiles) {
      double length = 0;
      for (std::size_t i = 0; i < tile.count(); ++i) length += length_of(tile.ends(i));
      sum += length * lattice.cell_area();
    }
    return sum;
  }
  [[nodiscard]] int first_column(std::size_t tile) const {
    return static_cast<int>(tile) % lattice.tiles_b() * Lattice::kTile;
  }
  [[nodiscard]] int first_row(std::size_t tile) const {
    return static_cast<int>(tile) / lattice.tiles_b() * Lattice::kTile;
  }
  [[nodiscard]] TileWork work(std::size_t tile, Vec3 middle) {
    return {lattice, tiles[tile], first_column(tile), first_row(tile), middle};
  }
  /// A dexel in its tile.
  struct Place {
    const Tile* tile;
    std::size_t dexel;
  };
  /// That of the cell that a place lies in.
  [[nodiscard]] std::optional<Place> dexel_at(Vec3 place) const {
    const double b =
        on_axis(place, (lattice.axis + 1) % 3) / lattice.cell_b + lattice.columns / 2.0;
    const double c = on_axis(place, (lattice.axis + 2) % 3) / lattice.cell_c + lattice.rows / 2.0;
    if (!(b >= 0 && b < lattice.columns && c >= 0 && c < lattice.rows)) return {};
    const int column = static_cast<int>(b);
    const int row = static_cast<int>(c);
    const Tile& tile = tiles[static_cast<std::size_t>(row / Lattice::kTile * lattice.tiles_b() +
                                                      column / Lattice::kTile)];
    return Place{&tile, tile.index(column % Lattice::kTile, row % Lattice::kTile)};
  }
  /// Whether it has material there.
  [[nodiscard]] bool holds(Vec3 place) const {
    const auto at = dexel_at(place);
    return at && at->tile->holds(at->dexel, static_cast<float>(on_axis(place, lattice.axis)));
  }
  /// From where to where the dexel has material, on a line along it; the line is from the middle.
  [[nodiscard]] Stretch material_on(const StraightWay& line) const {
    const auto at = dexel_at(line.from);
    if (!at || at->tile->ends(at->dexel).empty()) return {};
    const auto ends = at->tile->ends(at->dexel);
    Stretch all;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      all.add(shares(on_axis(line.from, lattice.axis), on_axis(line.to, lattice.axis),
                     double{ends[i].at}, double{ends[i + 1].at}));
    }
    return all;
  }
  /// act(tile) for each that has dexels in the box, which is from the middle of the stock.
  template <class Act>
  void each_in(const Bounds& box, Act&& act) const {
    const int b = (lattice.axis + 1) % 3;
    const int c = (lattice.axis + 2) % 3;
    const int a = lattice.axis;
    if (on_axis(box.low, a) > lattice.half_s || on_axis(box.high, a) < -lattice.half_s) return;
    const CellRange columns = lattice.columns_in(on_axis(box.low, b), on_axis(box.high, b));
    const CellRange rows = lattice.rows_in(on_axis(box.low, c), on_axis(box.high, c));
    if (columns.first > columns.last || rows.first > rows.last) return;
    for (int row = rows.first / Lattice::kTile; row <= rows.last / Lattice::kTile; ++row) {
      const int last = columns.last / Lattice::kTile;
      for (int column = columns.first / Lattice::kTile; column <= last; ++column) {
        act(static_cast<std::size_t>(row * lattice.tiles_b() + column));
      }
    }
  }
};

}  // namespace kerf::stock::dexel
