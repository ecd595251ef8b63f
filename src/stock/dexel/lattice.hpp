#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "stock/sweep/way.hpp"

namespace kerf::stock::dexel {

/// The component of a vector on axis 0, 1 or 2.
[[nodiscard]] constexpr double on_axis(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
[[nodiscard]] constexpr Vec3 along_axis(int axis, double s, double b, double c) {
  if (axis == 0) return {s, b, c};
  if (axis == 1) return {c, s, b};
  return {b, c, s};
}

/// Numbers of neighbours, both ends included; first > last: none.
struct CellRange {
  int first = 0;
  int last = -1;
};

/// Where the dexels of one direction stand. Coordinates are from the middle of the stock's box, so
/// that mirrored stocks have mirrored numbers: s along the dexels, b and c on the next axis and the
/// one after. Columns count along b, rows along c; dexels run through the middles of cells.
struct Lattice {
  static constexpr int kTile = 64;  ///< columns and rows of a tile

  int axis = 2;
  int columns = 0;
  int rows = 0;
  double cell_b = 0;
  double cell_c = 0;
  double half_s = 0;  ///< of the box, along the dexels

  [[nodiscard]] double b_of(int column) const { return (2 * column + 1 - columns) * (cell_b / 2); }
  [[nodiscard]] double c_of(int row) const { return (2 * row + 1 - rows) * (cell_c / 2); }
  [[nodiscard]] double cell_area() const { return cell_b * cell_c; }
  [[nodiscard]] int tiles_b() const { return (columns + kTile - 1) / kTile; }
  [[nodiscard]] int tiles_c() const { return (rows + kTile - 1) / kTile; }
  [[nodiscard]] CellRange columns_in(double low, double high) const {
    return cells_in(low, high, cell_b, columns);
  }
  [[nodiscard]] CellRange rows_in(double low, double high) const {
    return cells_in(low, high, cell_c, rows);
  }

 private:
  [[nodiscard]] static CellRange cells_in(double low, double high, double cell, int count) {
    const double middle = 0.5 * (count - 1);
    // Clamped first, and rounded by conversion: not every processor has an instruction for it.
    const double from = std::clamp(low / cell + middle - 1e-6, 0.0, 1.0 * count);
    const double to = std::clamp(high / cell + middle + 1e-6, -1.0, count - 1.0);
    const int first = static_cast<int>(from);
    const int last = static_cast<int>(to);
    return {first + (first < from ? 1 : 0), last - (last > to ? 1 : 0)};
  }
};

}  // namespace kerf::stock::dexel
