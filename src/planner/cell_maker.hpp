#pragma once

#include <array>

#include "planner/cell.hpp"
#include "planner/cell_limits.hpp"
#include "planner/linkage.hpp"
#include "planner/overrides.hpp"
#include "planner/path.hpp"
#include "planner/stretch.hpp"
#include "planner/stretch_bounds.hpp"

namespace kerf::planner {

/// Cuts the pieces of a path into cells. Where the driven axes are those of the program a piece is
/// one cell, or some of equal length, besides one for each of its borders (CellLimits), and its
/// curve has bounds of its own. Where the program's speed changes along a piece, cells are so short
/// that it is nearly constant in each (motion::PathSpeed), and take as long as it says.
///
/// Through a linkage the bounds come from samples. A cell is so short that these agree (Stretch),
/// and that it is driven nearly as fast as its fastest place allows, or at twice the feed, or
/// within a few periods. So cells become shorter towards a place where the rates of the driven axes
/// grow:
///
///     ├──────────────┼───────┼───┼─┼┤·   A piece may begin or end where they are not determined
///                                        (an arm stretched out). There the axes come to rest; the
///                                        last kAtEnd have the bounds of where they begin.
class CellMaker {
 public:
  static constexpr std::size_t kCells = 4096;
  // Shortest cells, mm, or degrees where only rotary axes move.
  static constexpr double kShortest = 1e-11;
  static constexpr double kAtEnd = 1e-9;

  /// The limits are those of the driven axes. `linkage` may be null: they are the program's. Both
  /// must outlive this.
  CellMaker(const CellLimits& limits, const Linkage* linkage);

  /// Makes cells of what has none yet, as far as there is room.
  void make(const Path& path, const Overrides& overrides, Ring<Cell>& cells);
  /// The limits of a cell of this piece under other overrides.
  [[nodiscard]] PathLimits limits_of(const Cell& cell, const PathPiece& piece,
                                     const Overrides& overrides) const;

  /// Number of the first piece that is not all cells yet.
  [[nodiscard]] std::uint64_t next_piece() const { return next_piece_; }
  /// There has been a piece whose speed changes along it.
  [[nodiscard]] bool has_cut_by_speed() const { return has_cut_by_speed_; }
  /// Pieces up to now need no cells.
  void skip_to(const Path& path);
  /// The driven axes stand here: where the next piece begins.
  void set_joints(const base::JointPoint& joints) { joints_ = joints; }

 private:
  [[nodiscard]] CellBounds bounds_of(const PathPiece& piece, double begin, double end) const;
  void split(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells);
  void split_inside(const PathPiece& piece, double begin, double end, const CellBounds& bounds,
                    const Overrides& overrides, Ring<Cell>& cells);
  [[nodiscard]] double most_end_of(const PathPiece& piece) const;
  void add_from_point_to_point(const PathPiece& piece, const Overrides& overrides,
                               Ring<Cell>& cells);
  bool cut_by_speed(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells);
  bool cut(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells);
  [[nodiscard]] double look(const PathPiece& piece, const JointSample& first, Stretch& stretch,
                            CellBounds& bounds) const;
  [[nodiscard]] double acceleration_at(const JointSample& end) const;
  [[nodiscard]] bool is_cell(const PathPiece& piece, const Stretch& stretch,
                             const StretchBends& bends, const CellBounds& bounds) const;
  void add(const PathPiece& piece, double begin, double end, const CellBounds& bounds,
           const Overrides& overrides, Ring<Cell>& cells);

  const CellLimits& limits_;
  const Linkage* linkage_;
  std::uint64_t next_piece_ = 0;
  bool has_cut_by_speed_ = false;
  base::JointPoint joints_;  // at the begin of the next cell

  // Of the piece that is being cut.
  std::size_t cells_of_piece_ = 0;
  double begin_ = 0;   // of the next cell
  double length_ = 0;  // of the last one
  double border_ = 0;  // at its ends
  double beside_ = 0;  // CellBounds::tip_acceleration of those
};

}  // namespace kerf::planner
