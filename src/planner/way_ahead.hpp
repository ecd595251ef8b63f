#pragma once

#include "motion/axis_setup.hpp"
#include "planner/cell_maker.hpp"
#include "planner/look_ahead.hpp"
#include "planner/path_builder.hpp"
#include "planner/settings.hpp"

namespace kerf::planner {

/// What lies ahead of the tool: motions become a path, the path is cut into cells, and these get
/// speeds. Who drives along it takes sections from its begin and leaves cells behind; who plans
/// anew works on its cells. Bounded memory, no allocation after the first motion.
struct WayAhead {
  /// As Interpolator has them.
  WayAhead(const motion::AxisSetup& axis_setup, const AxisLimits& axis_limits,
           const Settings& settings, const Linkage* linkage);
  WayAhead(const WayAhead&) = delete;
  WayAhead& operator=(const WayAhead&) = delete;

  /// Precondition of both: builder.room().
  void take(const motion::Motion& motion);
  void finish();
  /// Everything that was taken has been driven.
  [[nodiscard]] bool empty() const { return path.pieces.empty() && !builder.keeps_back(); }

  /// The next planned section, of cells made with these overrides. False when what is known of the
  /// path is not enough.
  [[nodiscard]] bool next_section(const Overrides& overrides, Section& section);
  /// Nothing follows what this plan has. Of constant speeds that is said of all that it has room
  /// for, once nothing is to come: the axes may rest there once. Speeds that change along the path
  /// have so many cells that they would do so often.
  [[nodiscard]] bool is_seen_to_its_end(const LookAhead& seen) const {
    if (!maker.has_cut_by_speed()) return ended;
    return ended && maker.next_piece() >= path.pieces.end() && seen.next_cell() >= cells.end();
  }
  /// The piece under way is of a thread, which nothing interrupts.
  [[nodiscard]] bool is_in_thread() const {
    return !path.pieces.empty() && path.pieces[path.pieces.begin()].thread;
  }
  /// The first cell is driven, and the pieces before the next one with it.
  void leave_cell();
  /// The motions are over that end before `at` of the first piece, by its parameter.
  void leave_marks(double at);
  /// The plan begins anew at rest, `offset` behind the begin of the first cell.
  void begin_at_rest(double offset) { plan.begin_at(cells.begin(), offset, 0); }
  /// Forgets everything; the next motion begins at `tip`.
  void forget(const base::TipPoint& tip);

  const motion::AxisSetup axes;
  const CellLimits limits;
  Path path;
  PathBuilder builder;
  CellMaker maker;
  Ring<Cell> cells{CellMaker::kCells};
  LookAhead plan;
  bool ended = false;  ///< nothing follows what was taken, as far as is known
};

}  // namespace kerf::planner
