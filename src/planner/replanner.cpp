#include "planner/replanner.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::planner {
namespace {

// Shorter than any motion, mm or degrees.
constexpr double kSameWay = 1e-9;

bool same_block(const motion::Mark& a, const motion::Mark& b) { return a.block == b.block; }

}  // namespace

// Leveling off

// What RampLimits hold at the acceleration of now.
bool Replanner::is_limit_kept(const Cell& cell, const PathState& from, double speed) const {
  constexpr double kSame = 1 - 1e-9;
  const double a = from.acceleration;
  const double most = std::max(speed, from.speed + a * a / (2 * cell.limits.jerk));
  return cell.limits.velocity >= most * kSame && cell.limits.acceleration >= std::fabs(a) * kSame;
}

// Finds the cells that the stretch ends in and passes. Returns the least jerk of them; nothing
// where one of them does not allow it.
std::optional<double> Replanner::cells_under(Section& stretch, const PathState& from) const {
  const Ring<Cell>& cells = ahead_.cells;
  double least = cells[from.cell].limits.jerk;
  for (std::uint64_t n = from.cell;; ++n) {
    if (n >= cells.end() || cells[n].dwell_s > 0) return std::nullopt;
    if (!is_limit_kept(cells[n], from, stretch.exit)) return std::nullopt;
    least = std::min(least, cells[n].limits.jerk);
    if (stretch.tail < cells[n].length()) return least;
    if (cells[n].stop) return std::nullopt;
    stretch.tail -= cells[n].length();
    ++stretch.cells;
  }
}

// With the jerk of the slowest cell that the stretch touches; which ones these are depends on the
// jerk in turn.
std::optional<Replanner::Leveling> Replanner::level_off(const PathState& from) const {
  const double a = from.acceleration;
  const double side = a > 0 ? 1 : -1;
  double jerk = ahead_.cells[from.cell].limits.jerk;
  for (;;) {
    const Phase phase{std::fabs(a) / jerk, from.speed, a, -side * jerk};
    const double speed = phase.velocity_at(phase.duration_s);
    if (!(speed > 0)) return std::nullopt;
    const double way = phase.way(phase.duration_s);
    Section section{way, {}, from.speed, speed, 0, from.offset + way, 0, false};
    const std::optional<double> slowest = cells_under(section, from);
    if (!slowest) return std::nullopt;
    const double least = std::min(jerk, *slowest);
    if (least == jerk)
      return Leveling{Profile(phase), section, {from.cell + section.cells, section.tail, speed, 0}};
    jerk = least;
  }
}

// To rest

bool Replanner::can_stop_within(const PathState& from, double way) {
  trial_.begin_at(from.cell, from.offset, from.speed);
  trial_.stop_after(way);
  trial_.absorb(ahead_.cells);
  return !trial_.empty() && trial_.plan(true);
}

bool Replanner::to_rest(const PathState& from) {
  double most = ramp_length(from.speed, 0, ahead_.cells[from.cell].limits);
  double least = 0;
  constexpr double kLongestWay = 1e6;
  for (; !can_stop_within(from, most); most *= 2) {
    if (most > kLongestWay) return false;
    least = most;
  }
  while (most - least > 1e-3 * most) {
    const double middle = least + (most - least) / 2;
    (can_stop_within(from, middle) ? most : least) = middle;
  }
  return can_stop_within(from, most);
}

// How far a mark is from a place on the way to it; nothing where the path is not known that far.
std::optional<double> Replanner::way_to(const PathMark& mark, const PathState& from) const {
  double way = -from.offset;
  for (std::uint64_t n = from.cell; n < ahead_.cells.end(); ++n) {
    const Cell& cell = ahead_.cells[n];
    if (cell.piece > mark.piece) return way;
    if (cell.piece == mark.piece && mark.way <= cell.end)
      return way + std::max(0.0, mark.way - cell.begin);
    way += cell.length();
  }
  return std::nullopt;
}

bool Replanner::ends_in_standstill(const PathMark& mark) const {
  if (mark.piece >= ahead_.path.pieces.end()) return false;
  const PathPiece& piece = ahead_.path.pieces[mark.piece];
  return piece.dwell_s > 0 || (piece.stop && mark.way >= piece.end - kSameWay);
}

// Where blocks end in a standstill the plan stays as it is.
bool Replanner::to_block_end(const PathState& from) {
  const Ring<PathMark>& marks = ahead_.path.marks;
  for (std::uint64_t n = marks.begin(); n < marks.end(); ++n) {
    const PathMark& mark = marks[n];
    if (n + 1 < marks.end() && same_block(mark.mark, marks[n + 1].mark)) continue;
    const std::optional<double> way = way_to(mark, from);
    if (!way || (*way > kSameWay && ends_in_standstill(mark))) return false;
    if (*way > kSameWay && can_stop_within(from, *way)) return true;
  }
  return false;
}

bool Replanner::is_over(const motion::Mark& mark, double offset) const {
  const Ring<PathMark>& marks = ahead_.path.marks;
  const PathState here{ahead_.cells.begin(), offset, 0, 0};
  for (std::uint64_t n = marks.begin(); n < marks.end(); ++n) {
    const std::optional<double> way = way_to(marks[n], here);
    if (!way || *way > kSameWay) return !same_block(marks[n].mark, mark);
  }
  return true;
}

// Overrides

// The cells that are nearest keep the limits that they had, as many as it takes to slow down to the
// new ones.
bool Replanner::to_overrides(const PathState& from, const Overrides& wanted) {
  const Ring<Cell>& cells = ahead_.cells;
  for (std::uint64_t kept = 0;; kept = kept == 0 ? 1 : 2 * kept) {
    const std::uint64_t first = std::min(from.cell + kept, cells.end());
    override_cells(first, wanted);
    trial_.begin_at(from.cell, from.offset, from.speed);
    trial_.absorb(cells);
    if (trial_.plan(ahead_.is_seen_to_its_end(trial_))) return true;
    put_back_overrides(first);
    if (first == cells.end()) return false;
  }
}

void Replanner::override_cells(std::uint64_t first, const Overrides& wanted) {
  for (std::uint64_t n = first; n < ahead_.cells.end(); ++n) {
    ahead_.cells[n].former_overrides = ahead_.cells[n].overrides;
    set_overrides_of(n, wanted);
  }
}

// Not all cells have the same: those that an earlier change has left alone keep theirs.
void Replanner::put_back_overrides(std::uint64_t first) {
  for (std::uint64_t n = first; n < ahead_.cells.end(); ++n)
    set_overrides_of(n, ahead_.cells[n].former_overrides);
}

void Replanner::set_overrides_of(std::uint64_t cell, const Overrides& overrides) {
  Cell& c = ahead_.cells[cell];
  c.overrides = overrides;
  if (c.dwell_s == 0) c.limits = ahead_.maker.limits_of(c, ahead_.path.pieces[c.piece], overrides);
}

}  // namespace kerf::planner
