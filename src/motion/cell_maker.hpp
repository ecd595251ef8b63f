#pragma once

#include <array>

#include "motion/cell.hpp"
#include "motion/cell_limits.hpp"
#include "motion/linkage.hpp"
#include "motion/overrides.hpp"
#include "motion/path.hpp"

namespace kerf::motion {

/// Cuts the pieces of a path into cells. Where the driven axes are those of the program a piece is
/// one cell, or some of equal length; otherwise a cell is so short that the derivatives of the
/// driven axes change little in it.
class CellMaker {
 public:
  static constexpr std::size_t kCells = 4096;

  /// The limits are those of the driven axes. `linkage` may be null: they are the program's. Both
  /// must outlive this.
  CellMaker(const CellLimits& limits, const Linkage* linkage)
      : limits_(limits), linkage_(linkage) {}

  /// Makes cells of the pieces that have none yet, as far as there is room.
  void make(const Path& path, const Overrides& overrides, Ring<Cell>& cells);
  /// The limits of a cell under other overrides.
  [[nodiscard]] PathLimits limits_of(const Cell& cell, const PathPiece& piece,
                                     const Overrides& overrides) const;

  /// Pieces up to now need no cells.
  void skip_to(const Path& path) { next_piece_ = path.pieces.end(); }
  /// The driven axes stand here: where the next piece begins.
  void set_joints(const base::AxisVector& joints) { joints_ = joints; }

 private:
  void split(const PathPiece& piece, std::uint64_t number, const Overrides& overrides,
             Ring<Cell>& cells);
  void cut(const PathPiece& piece, std::uint64_t number, const Overrides& overrides,
           Ring<Cell>& cells);
  void add(const PathPiece& piece, std::uint64_t number, double begin, double end,
           const CurveBounds& bounds, const Overrides& overrides, Ring<Cell>& cells);

  const CellLimits& limits_;
  const Linkage* linkage_;
  std::uint64_t next_piece_ = 0;
  base::AxisVector joints_;
};

}  // namespace kerf::motion
