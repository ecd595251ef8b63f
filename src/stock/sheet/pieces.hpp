#pragma once

#include <cstdint>
#include <vector>

#include "stock/sheet/sheet.hpp"

namespace kerf::stock::sheet {

/// A part of the sheet that hangs together.
struct Piece {
  double area_mm2 = 0;
  Box extents;                   ///< of the cells that count as left
  bool is_held = false;          ///< touches the border of the sheet
  std::uint64_t first_cell = 0;  ///< the first of its cells, by rows
};

struct Pieces {
  static constexpr std::size_t kMost = 1000;
  std::vector<Piece>
      largest;              ///< the largest first, of equals the one whose first cell comes first
  std::uint64_t count = 0;  ///< of all
};

/// The 4-connected parts of what is left of a sheet. A cell counts as left below
/// Sheet::cut_from(); what little is left of one that is cut belongs to the piece beside it. Linear
/// in the cells of the tiles that were touched.
[[nodiscard]] Pieces pieces_of(const Sheet& sheet);

}  // namespace kerf::stock::sheet
