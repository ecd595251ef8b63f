#pragma once

#include <array>
#include <span>

#include "stock/surface/contouring.hpp"
#include "stock/surface/internal/cell_cycles.hpp"

namespace kerf::stock::surface {

/// Makes the patch of one block.
///
/// Of a block the cells [begin, end) are its own. Their triangles also need the points of the cells
/// before them; a point that falls onto one of a neighbouring cell gives way, which needs that
/// cell's points; and how lines run through a cell may depend on the next one: so signs are known
/// three points around.
class PatchMaker {
 public:
  PatchMaker(const Samples& samples, Place begin, Place end);

  [[nodiscard]] Patch make();

  static constexpr int kAround = 3;  ///< points

 private:
  /// A corner of the surface before others are asked.
  struct Corner {
    Vec3 place;
    Vec3 normal;  ///< sum
    Vec3 inner;   ///< a place inside of the cell that no other corner has
    std::uint32_t owner = 0;
  };
  struct Cell {
    CellCycles cycles;
    std::array<Corner, 4> corners;
  };
  struct Entry {
    Place cell;
    std::size_t cell_number;
    std::uint8_t line;
    std::uint32_t point;
  };

  [[nodiscard]] std::uint8_t form(Place cell) const;
  [[nodiscard]] std::uint8_t turned(Place cell) const;
  [[nodiscard]] std::size_t local(Place cell) const;
  /// Index of the cell in cells_, made when it is asked for; the surface passes it.
  std::size_t cell(Place at);
  [[nodiscard]] Cell make_cell(Place at) const;
  void make_corners(Place at, Cell& cell) const;
  [[nodiscard]] Crossing crossing(Place cell, int edge) const;
  [[nodiscard]] Vec3 clamped(Place cell, Vec3 p) const;
  [[nodiscard]] bool is_at_border(Place cell, Vec3 p) const;
  [[nodiscard]] bool is_shared(Place at, std::uint8_t line);
  [[nodiscard]] Vec3 settled(Place at, std::uint8_t line);
  void add_points(Place at, Patch& patch);
  void add_quad(Place from, int axis, Patch& patch);
  void add_triangles(std::array<std::uint32_t, 4> corners, int axis, std::uint32_t owner,
                     Patch& patch) const;
  [[nodiscard]] std::uint32_t point_of(Place cell, int edge) const;
  [[nodiscard]] std::uint64_t key(Place cell, std::uint8_t line) const;
  [[nodiscard]] double at(int axis, int point) const;

  const Samples& samples_;
  Place begin_;
  Place end_;
  Signs signs_;
  double near_;  ///< points nearer than this to each other give way
  std::vector<Cell> cells_;
  std::vector<std::int32_t> numbers_;                 // of cells in cells_; -1: not made
  std::vector<std::array<std::uint32_t, 4>> points_;  // of cells: in the patch
};

}  // namespace kerf::stock::surface
