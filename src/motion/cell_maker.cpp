#include "motion/cell_maker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::motion {
namespace {

using base::AxisVector;
using base::PathJet;

// Most cells of one piece.
constexpr std::size_t kMostCells = 256;
// Within a cell a derivative may differ by this share of its largest value; that much is added.
constexpr double kMostChange = 0.05;

double largest(const AxisVector& v) {
  double most = 0;
  for (const double value : v.values) most = std::max(most, std::fabs(value));
  return most;
}

/// Bounds over a part of a curve from derivatives at its begin, middle and end.
struct Samples {
  std::array<PathJet, 3> jets;

  [[nodiscard]] AxisVector bound(AxisVector PathJet::*derivative, double& change) const {
    AxisVector result;
    const double scale = std::max(
        {largest(jets[0].*derivative), largest(jets[1].*derivative), largest(jets[2].*derivative)});
    for (std::size_t m = 0; m < base::kMaxAxes; ++m) {
      const auto value = [&](std::size_t i) { return (jets[i].*derivative).values[m]; };
      const auto [low, high] = std::minmax({value(0), value(1), value(2)});
      if (scale > 0) change = std::max(change, (high - low) / scale);
      result.values[m] = std::max(std::fabs(low), std::fabs(high)) + (high - low) / 2;
    }
    return result;
  }
};

}  // namespace

void CellMaker::make(const Path& path, const Overrides& overrides, Ring<Cell>& cells) {
  const std::size_t needed = linkage_ == nullptr ? 1 : kMostCells;
  next_piece_ = std::max(next_piece_, path.pieces.begin());
  for (; next_piece_ < path.pieces.end() && cells.room() >= needed; ++next_piece_) {
    const PathPiece& piece = path.pieces[next_piece_];
    if (piece.dwell_s > 0) {
      Cell& cell = cells.push();
      cell = {};
      cell.piece = next_piece_;
      cell.dwell_s = piece.dwell_s;
      cell.stop = true;
    } else if (linkage_ == nullptr) {
      add(piece, next_piece_, piece.begin, piece.end, piece.curve.bounds(piece.begin, piece.end),
          overrides, cells);
    } else {
      cut(piece, next_piece_, overrides, cells);
    }
  }
}

// Each cell is tried at twice the length of the one before, and halved until it is flat enough.
void CellMaker::cut(const PathPiece& piece, std::uint64_t number, const Overrides& overrides,
                    Ring<Cell>& cells) {
  const double shortest = (piece.end - piece.begin) / static_cast<double>(kMostCells);
  double begin = piece.begin;
  double length = piece.end - piece.begin;
  Samples samples;
  samples.jets[0] = linkage_->along(piece.curve.jet(begin), joints_);
  while (begin < piece.end) {
    length = std::min(2 * length, piece.end - begin);
    CurveBounds bounds;
    for (;; length = std::max(length / 2, shortest)) {
      if (begin + length > piece.end - shortest / 2) length = piece.end - begin;
      samples.jets[1] = linkage_->along(piece.curve.jet(begin + length / 2), samples.jets[0].value);
      samples.jets[2] = linkage_->along(piece.curve.jet(begin + length), samples.jets[1].value);
      double change = 0;
      bounds.first = samples.bound(&PathJet::first, change);
      bounds.second = samples.bound(&PathJet::second, change);
      bounds.third = samples.bound(&PathJet::third, change);
      if (change <= kMostChange || length <= 1.01 * shortest) break;
    }
    const double end = length == piece.end - begin ? piece.end : begin + length;
    add(piece, number, begin, end, bounds, overrides, cells);
    begin = end;
    samples.jets[0] = samples.jets[2];
  }
  joints_ = samples.jets[2].value;
}

void CellMaker::add(const PathPiece& piece, std::uint64_t number, double begin, double end,
                    const CurveBounds& bounds, const Overrides& overrides, Ring<Cell>& cells) {
  Cell& cell = cells.push();
  cell.piece = number;
  cell.begin = begin;
  cell.end = end;
  cell.bounds = bounds;
  cell.dwell_s = 0;
  cell.stop = piece.stop && end == piece.end;
  cell.limits = limits_of(cell, piece, overrides);
}

PathLimits CellMaker::limits_of(const Cell& cell, const PathPiece& piece,
                                const Overrides& overrides) const {
  if (piece.fixed_override) return limits_.of(cell.bounds, piece.feed, piece.use);
  if (!piece.rapid) return limits_.of(cell.bounds, piece.feed * overrides.feed, piece.use);
  const PathLimits full = limits_.of(cell.bounds, piece.feed, piece.use);
  return limits_.of(cell.bounds, full.velocity * overrides.rapid, piece.use);
}

}  // namespace kerf::motion
