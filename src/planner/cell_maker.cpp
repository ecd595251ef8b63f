#include "planner/cell_maker.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::planner {
namespace {

// Most cells of one piece whose driven axes are the program's.
constexpr std::size_t kMostParts = 24;
// Such a piece whose shape takes less than this share of an acceleration or jerk is one cell; of
// others a ramp to full speed passes over about so many.
constexpr double kLittle = 0.1;
constexpr double kPartsOfRamp = 6;
// Share of the speed that a cell may cost where it could be driven faster.
constexpr double kMostLoss = 0.15;
// A cell that takes no more than these at its speed costs little, however slow it is.
constexpr double kFewPeriods = 8;
// Fastest that an operator makes of a feed.
constexpr double kMostOverride = 2;
// A piece of more cells than this, of which each is as short as can be, cannot be driven anyway:
// the rest of it is cut into equal cells.
constexpr std::size_t kMostFineCells = 4096;
constexpr double kCoarseCells = 256;

}  // namespace

CellMaker::CellMaker(const CellLimits& limits, const Linkage* linkage)
    : limits_(limits), linkage_(linkage) {
  if (linkage_ != nullptr) joints_ = linkage_->start();
}

void CellMaker::skip_to(const Path& path) {
  next_piece_ = path.pieces.end();
  cells_of_piece_ = 0;
}

void CellMaker::make(const Path& path, const Overrides& overrides, Ring<Cell>& cells) {
  const std::size_t needed = linkage_ == nullptr ? kMostParts + 2 : 1;
  next_piece_ = std::max(next_piece_, path.pieces.begin());
  for (; next_piece_ < path.pieces.end() && cells.room() >= needed; ++next_piece_) {
    const PathPiece& piece = path.pieces[next_piece_];
    if (piece.dwell_s > 0) {
      Cell& cell = cells.push();
      cell = {};
      cell.piece = next_piece_;
      cell.dwell_s = piece.dwell_s;
      cell.stop = true;
    } else if (linkage_ != nullptr && piece.rapid && piece.curve.is_arc()) {
      add_from_point_to_point(piece, overrides, cells);
    } else if (linkage_ != nullptr) {
      if (!cut(piece, overrides, cells)) return;
    } else if (piece.speed.is_constant()) {
      split(piece, overrides, cells);
    } else if (!cut_by_speed(piece, overrides, cells)) {
      return;
    }
  }
}

CellBounds CellMaker::bounds_of(const PathPiece& piece, double begin, double end) const {
  CellBounds bounds{.driven = piece.curve.bounds(begin, end)};
  bounds.curvature = piece.curve.curvature_bound(begin, end, bounds.driven, limits_.linear());
  return bounds;
}

// One cell and two for its borders, if it has some.
void CellMaker::split(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells) {
  CellBounds bounds = bounds_of(piece, piece.begin, piece.end);
  const double border = limits_.border_mm(bounds);
  const double begin = piece.begin + border;
  const double end = piece.end - border;
  if (border == 0) return split_inside(piece, piece.begin, piece.end, bounds, overrides, cells);
  bounds.at_border = true;
  if (begin >= end) return add(piece, piece.begin, piece.end, bounds, overrides, cells);
  add(piece, piece.begin, begin, bounds, overrides, cells);
  bounds.at_border = false;
  split_inside(piece, begin, end, bounds, overrides, cells);
  bounds.at_border = true;
  add(piece, end, piece.end, bounds, overrides, cells);
}

// One cell, or several where the shape takes much of the acceleration: then what is left depends on
// the speed, and parts that are passed at different speeds should not share one limit.
void CellMaker::split_inside(const PathPiece& piece, double begin, double end,
                             const CellBounds& bounds, const Overrides& overrides,
                             Ring<Cell>& cells) {
  add(piece, begin, end, bounds, overrides, cells);
  const PathLimits& limits = cells.back().limits;
  if (piece.curve.is_line() || piece.use == CellLimits::Use::corner) return;
  if (limits_.share_of_shape(bounds, limits.velocity) < kLittle) return;
  const double ramp = limits.velocity * limits.velocity / (2 * limits.acceleration);
  const double length = end - begin;
  const double wanted = std::ceil(length / ramp * kPartsOfRamp);
  const auto parts = static_cast<int>(std::min(wanted, static_cast<double>(kMostParts)));
  if (parts < 2) return;
  cells.unpush();
  for (int i = 0; i < parts; ++i) {
    const double from = begin + length * i / parts;
    const double to = i + 1 == parts ? end : begin + length * (i + 1) / parts;
    add(piece, from, to, bounds_of(piece, from, to), overrides, cells);
  }
}

// False: there is no more room, and the piece goes on.
bool CellMaker::cut_by_speed(const PathPiece& piece, const Overrides& overrides,
                             Ring<Cell>& cells) {
  has_cut_by_speed_ = true;
  if (cells_of_piece_ == 0) {
    begin_ = piece.begin;
    border_ = limits_.border_mm(bounds_of(piece, piece.begin, piece.end));
  }
  for (; begin_ < piece.end; ++cells_of_piece_) {
    if (cells.room() < kMostParts) return false;
    const double end = piece.speed.part_end(piece.curve, begin_, most_end_of(piece));
    CellBounds bounds = bounds_of(piece, begin_, end);
    bounds.at_border = begin_ < piece.begin + border_ || end > piece.end - border_;
    if (bounds.at_border) {
      add(piece, begin_, end, bounds, overrides, cells);
    } else {
      split_inside(piece, begin_, end, bounds, overrides, cells);
    }
    begin_ = end;
  }
  cells_of_piece_ = 0;
  return true;
}

// False: there is no more room, and the piece goes on.
bool CellMaker::cut(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells) {
  if (cells_of_piece_ == 0) {
    begin_ = piece.begin;
    length_ = piece.end - piece.begin;
  }
  Stretch stretch(*linkage_, piece.curve);
  JointSample first = stretch.look_at(begin_, joints_);
  if (cells_of_piece_ == 0) {
    CellBounds bounds = bounds_of(piece, piece.begin, piece.end);
    beside_ =
        std::max(acceleration_at(first), acceleration_at(stretch.look_at(piece.end, first.joints)));
    bounds.tip_acceleration = beside_;
    border_ = limits_.border_mm(bounds);
  }
  while (begin_ < piece.end) {
    if (cells.room() == 0) return false;
    CellBounds bounds;
    const double end = look(piece, first, stretch, bounds);
    first = stretch.samples()[2];
    add(piece, begin_, end, bounds, overrides, cells);
    cells.back().stop |= end == piece.end && !first.rates;
    begin_ = end;
    length_ = stretch.length();
    joints_ = first.joints;
    ++cells_of_piece_;
  }
  cells_of_piece_ = 0;
  return true;
}

// The driven axes go in proportion to the parameter (motion::TurningRapid), so the tip leaves the
// path nowhere.
void CellMaker::add_from_point_to_point(const PathPiece& piece, const Overrides& overrides,
                                        Ring<Cell>& cells) {
  Stretch stretch(*linkage_, piece.curve);
  const JointSample begin = stretch.look_at(piece.begin, joints_);
  stretch.look(piece.begin, begin, piece.end);
  joints_ = stretch.samples()[2].joints;
  const base::AxisVector way = joints_ - begin.joints;
  CellBounds bounds;
  for (std::size_t m = 0; m < linkage_->size(); ++m)
    bounds.driven.first.values[m] = std::fabs(way.values[m]) / stretch.length();
  add(piece, piece.begin, piece.end, bounds, overrides, cells);
}

// Where the next cell ends at the latest: a border is not one with what lies between.
double CellMaker::most_end_of(const PathPiece& piece) const {
  const double begin = piece.begin + border_;
  const double end = piece.end - border_;
  if (border_ == 0 || begin >= end || begin_ >= end) return piece.end;
  return begin_ < begin ? begin : end;
}

// Finds the next cell, tried at twice the length of the one before and halved until it is one.
// Returns its end.
double CellMaker::look(const PathPiece& piece, const JointSample& first, Stretch& stretch,
                       CellBounds& bounds) const {
  const bool fine = cells_of_piece_ < kMostFineCells;
  const double coarse = fine ? 0 : (piece.end - piece.begin) / kCoarseCells;
  for (double length = 2 * length_;; length = stretch.length() / 2) {
    const double most = piece.speed.part_end(piece.curve, begin_, most_end_of(piece));
    // What would remain behind the cell must not be shorter than a cell.
    const bool last = begin_ + length + kShortest > most;
    const double end = last ? most : begin_ + length;
    stretch.look(begin_, first, end);
    const StretchBends bends = bends_of(stretch, *linkage_, limits_.axis_limits().acceleration);
    bounds = planner::bounds_of(stretch, bends, bounds_of(piece, begin_, end).curvature,
                                linkage_->size());
    bounds.at_border = begin_ < piece.begin + border_ || end > piece.end - border_;
    if (bounds.at_border) bounds.tip_acceleration = beside_;
    const bool at_end = !first.rates || !stretch.samples()[2].rates;
    const double shortest = std::max(coarse, at_end ? kAtEnd : 2 * kShortest);
    if (stretch.length() <= shortest || is_cell(piece, stretch, bends, bounds)) return end;
  }
}

// Of the tip where a curve ends: there its parameter is a length, and what lies beside it goes on
// in its direction.
double CellMaker::acceleration_at(const JointSample& end) const {
  return end.rates ? limits_.acceleration_along(end.rates->first) : 0;
}

bool CellMaker::is_cell(const PathPiece& piece, const Stretch& stretch, const StretchBends& bends,
                        const CellBounds& bounds) const {
  if (!stretch.agrees()) return false;
  const double speed = limits_.highest_speed(bounds, piece.use);
  const double end = begin_ + stretch.length();
  if (speed >= kMostOverride * piece.speed.mean(piece.curve, begin_, end)) return true;
  if (stretch.length() <= kFewPeriods * limits_.period_s() * speed) return true;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const CellBounds at = bounds_at(*stretch.samples()[i].rates, bends[i], bounds);
    if (speed < (1 - kMostLoss) * limits_.highest_speed(at, piece.use)) return false;
  }
  return true;
}

void CellMaker::add(const PathPiece& piece, double begin, double end, const CellBounds& bounds,
                    const Overrides& overrides, Ring<Cell>& cells) {
  Cell& cell = cells.push();
  cell.piece = next_piece_;
  cell.begin = begin;
  cell.end = end;
  cell.dwell_s = 0;
  cell.stop = piece.stop && end == piece.end;
  cell.bounds = bounds;
  cell.limits = limits_of(cell, piece, overrides);
  cell.overrides = cell.former_overrides = overrides;
}

PathLimits CellMaker::limits_of(const Cell& cell, const PathPiece& piece,
                                const Overrides& overrides) const {
  const double feed = piece.speed.mean(piece.curve, cell.begin, cell.end);
  if (piece.fixed_override) return limits_.of(cell.bounds, feed, piece.use);
  if (!piece.rapid) return limits_.of(cell.bounds, feed * overrides.feed, piece.use);
  const PathLimits full = limits_.of(cell.bounds, feed, piece.use);
  return limits_.of(cell.bounds, full.velocity * overrides.rapid, piece.use);
}

}  // namespace kerf::planner
