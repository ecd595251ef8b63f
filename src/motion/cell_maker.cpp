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
// The same, of pieces whose driven axes are the program's.
constexpr std::size_t kMostParts = 24;
// A piece whose shape takes less than this share of the acceleration is one cell; of others a ramp
// to full speed passes over about so many.
constexpr double kLittle = 0.1;
constexpr double kPartsOfRamp = 6;
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
  const std::size_t needed = linkage_ == nullptr ? kMostParts : kMostCells;
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
      split(piece, next_piece_, overrides, cells);
    } else {
      cut(piece, next_piece_, overrides, cells);
    }
  }
}

// One cell, or several where the shape takes much of the acceleration: then what is left depends on
// the speed, and parts that are passed at different speeds should not share one limit.
void CellMaker::split(const PathPiece& piece, std::uint64_t number, const Overrides& overrides,
                      Ring<Cell>& cells) {
  const std::uint64_t first = cells.end();
  const CurveBounds bounds = piece.curve.bounds(piece.begin, piece.end);
  add(piece, number, piece.begin, piece.end, bounds, overrides, cells);
  const PathLimits limits = cells[first].limits;
  const double taken = limits.fall * limits.velocity * limits.velocity;
  if (piece.use == CellLimits::Use::corner || taken < kLittle * limits.acceleration) return;
  const double ramp = limits.velocity * limits.velocity / (2 * limits.acceleration);
  const double length = piece.end - piece.begin;
  const double wanted = std::ceil(length / ramp * kPartsOfRamp);
  const auto parts = static_cast<int>(std::min(wanted, static_cast<double>(kMostParts)));
  if (parts < 2) return;
  cells.unpush();
  for (int i = 0; i < parts; ++i) {
    const double begin = piece.begin + length * i / parts;
    const double end = i + 1 == parts ? piece.end : piece.begin + length * (i + 1) / parts;
    add(piece, number, begin, end, piece.curve.bounds(begin, end), overrides, cells);
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
  cell.overrides = cell.former_overrides = overrides;
}

PathLimits CellMaker::limits_of(const Cell& cell, const PathPiece& piece,
                                const Overrides& overrides) const {
  if (piece.fixed_override) return limits_.of(cell.bounds, piece.feed, piece.use);
  if (!piece.rapid) return limits_.of(cell.bounds, piece.feed * overrides.feed, piece.use);
  const PathLimits full = limits_.of(cell.bounds, piece.feed, piece.use);
  return limits_.of(cell.bounds, full.velocity * overrides.rapid, piece.use);
}

}  // namespace kerf::motion
