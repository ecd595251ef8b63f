#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "stock/sheet/grid.hpp"
#include "stock/sheet/internal/tile_list.hpp"

namespace kerf::stock::sheet {

/// The energy that a round even spot leaves on a straight way at a steady speed and power.
struct Burn {
  Vec2 from;
  Vec2 to;  ///< may be `from`: it stands
  double energy_j = 0;
};

/// What of a sheet a beam has gone over, and how much energy each place got (stock.md §4.7): tiles
/// of 64 × 64 cells, of which only those exist that something came to.
///
/// The coverage of a cell at the distance d from a way is clamp(½ + (kerf/2 − d)/h, 0, 1); where a
/// kerf is thinner than a cell, as much of it as lies in the cell. Several cover as much as the one
/// that covers most. Energies are those of the cell's middle, J/mm², and add up:
///
///   F = E / (π d²/4) · share of the way with the place within the spot;  along a straight way,
///   F(y) = (P/v) · 2√(d²/4 − y²) / (π d²/4)
///
/// Not for several threads at once; cut() and burn() use up to `jobs` of their own, and what comes
/// out does not depend on how many, nor on how ways are divided among calls.
class Sheet {
 public:
  struct Settings {
    double kerf_mm = 0.1;                     ///< > 0
    double spot_mm = 0;                       ///< of burns, diameter; 0: energy is not kept
    std::size_t memory_bytes = 1024UL << 20;  ///< more tiles are left out: missing_tiles()
    unsigned jobs = 1;
  };
  Sheet(const Grid& grid, const Settings& settings);

  /// Cuts along the traces, clean through.
  void cut(std::span<const Trace> traces);
  void burn(std::span<const Burn> burns);

  [[nodiscard]] double cut_mm2() const;
  /// The most that one cell got.
  [[nodiscard]] double peak_j_mm2() const;
  /// Σ energy · area over the cells: what of the burns came to the sheet, as far as cells know it.
  [[nodiscard]] double energy_on_sheet_j() const;

  [[nodiscard]] const Grid& grid() const { return grid_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::size_t touched_tiles() const { return tiles_.size(); }
  /// That would exist if the memory held them. Not 0: what is told here is not the whole.
  [[nodiscard]] std::size_t missing_tiles() const { return missing_; }
  [[nodiscard]] std::size_t bytes() const;

  using Coverage = std::array<std::uint8_t, kTileCells>;
  using Energy = std::array<float, kTileCells>;
  /// Of a tile, cells by rows along X, 255 covered; null: nothing came to it. A tile at the end of
  /// the grid has cells beyond it, which mean nothing.
  [[nodiscard]] const Coverage* coverage(std::size_t tile) const;
  /// J/mm²; null: nothing came to it, or energy is not kept.
  [[nodiscard]] const Energy* energy(std::size_t tile) const;
  /// How often a tile was cut, or burnt; restoring counts as once.
  [[nodiscard]] std::uint64_t cuts_of(std::size_t tile) const;
  [[nodiscard]] std::uint64_t burns_of(std::size_t tile) const;
  /// Puts back what coverage() or energy() told of a tile of an equal grid; null: nothing came to
  /// it. Energy goes where none is kept. False: the memory does not hold it.
  [[nodiscard]] bool restore_coverage(std::size_t tile, const Coverage* cells);
  [[nodiscard]] bool restore_energy(std::size_t tile, const Energy* cells);

  /// A cell counts as cut from so much: half of what one in the middle of a kerf has.
  [[nodiscard]] std::uint8_t cut_from() const;

 private:
  struct Tile {
    Coverage coverage{};
    std::unique_ptr<Energy> energy;
    std::uint64_t cuts = 0;
    std::uint64_t burns = 0;
  };

  template <typename Item>
  void work(std::span<const Item> items, double reach);
  [[nodiscard]] Tile* touch(std::size_t tile);
  [[nodiscard]] const Tile* touched(std::size_t tile) const;
  [[nodiscard]] std::size_t bytes_of_tile() const;

  Grid grid_;
  Settings settings_;
  std::vector<std::uint32_t> places_;  // of each tile: 0 untouched, kMissing, else 1 + its number
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t most_tiles_ = 0;
  std::size_t missing_ = 0;
};

}  // namespace kerf::stock::sheet
