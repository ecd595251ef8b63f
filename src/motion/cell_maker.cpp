#include "motion/cell_maker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::motion {
namespace {

using base::AxisVector;
using base::PathJet;

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

double largest(const AxisVector& v) {
  double most = 0;
  for (const double value : v.values) most = std::max(most, std::fabs(value));
  return most;
}

/// The largest absolute value of what was seen.
class Most {
 public:
  void see(double value) { value_ = std::max(value_, std::fabs(value)); }
  /// Of the polynomial of degree 3 with these values and derivatives at both ends of an interval,
  /// from its coefficients in Bernstein's form.
  void see(double begin, double begin_rate, double end, double end_rate, double width) {
    see(begin);
    see(begin + width / 3 * begin_rate);
    see(end - width / 3 * end_rate);
    see(end);
  }
  /// Of the parabola through three values at equal distances.
  void see(double begin, double middle, double end) {
    see(begin);
    see(2 * middle - (begin + end) / 2);
    see(end);
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0;
};

/// The least and the most of what was seen.
class Range {
 public:
  void see(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double width() const { return std::max(0.0, high_ - low_); }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

// Between two samples that agree a function is nearly the polynomial with its values and
// derivatives there; this much more is left to it.
constexpr double kALittle = 1.02;

double bound(const Stretch& stretch, AxisVector PathJet::*value, AxisVector PathJet::*rate,
             std::size_t m) {
  Most most;
  for (const JointSample& sample : stretch.samples()) {
    if (sample.rates) most.see(((*sample.rates).*value).values[m]);
  }
  for (std::size_t i = 1; i < stretch.samples().size(); ++i) {
    const auto& a = stretch.samples()[i - 1].rates;
    const auto& b = stretch.samples()[i].rates;
    if (!a || !b) continue;
    most.see(((*a).*value).values[m], ((*a).*rate).values[m], ((*b).*value).values[m],
             ((*b).*rate).values[m], stretch.length() / 2);
  }
  return kALittle * most.value();
}

// Of the highest derivative less is known: a quarter of what the samples differ by is added.
double bound_of_third(const Stretch& stretch, std::size_t m) {
  const auto& [a, b, c] = stretch.samples();
  Most most;
  Range range;
  for (const JointSample& sample : stretch.samples()) {
    if (!sample.rates) continue;
    most.see(sample.rates->third.values[m]);
    range.see(sample.rates->third.values[m]);
  }
  if (a.rates && b.rates && c.rates)
    most.see(a.rates->third.values[m], b.rates->third.values[m], c.rates->third.values[m]);
  return kALittle * (most.value() + range.width() / 4);
}

CellBounds bounds_at(const PathJet& rates, const CellBounds& cell) {
  CellBounds bounds = cell;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m) {
    bounds.driven.first.values[m] = std::fabs(rates.first.values[m]);
    bounds.driven.second.values[m] = std::fabs(rates.second.values[m]);
    bounds.driven.third.values[m] = std::fabs(rates.third.values[m]);
  }
  return bounds;
}

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
  next_piece_ = std::max(next_piece_, path.pieces.begin());
  for (; next_piece_ < path.pieces.end() && cells.room() > 0; ++next_piece_) {
    const PathPiece& piece = path.pieces[next_piece_];
    if (piece.dwell_s > 0) {
      Cell& cell = cells.push();
      cell = {};
      cell.piece = next_piece_;
      cell.dwell_s = piece.dwell_s;
      cell.stop = true;
    } else if (linkage_ == nullptr) {
      const CellBounds bounds{piece.curve.bounds(piece.begin, piece.end),
                              piece.curve.curvature_bound(piece.begin, piece.end, limits_.linear()),
                              0};
      add(piece, piece.begin, piece.end, bounds, overrides, cells);
    } else if (!cut(piece, overrides, cells)) {
      return;
    }
  }
}

// False: there is no more room, and the piece goes on.
bool CellMaker::cut(const PathPiece& piece, const Overrides& overrides, Ring<Cell>& cells) {
  if (cells_of_piece_ == 0) {
    begin_ = piece.begin;
    length_ = piece.end - piece.begin;
  }
  Stretch stretch(*linkage_, piece.curve);
  JointSample first = stretch.look_at(begin_, joints_);
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

// Finds the next cell, tried at twice the length of the one before and halved until it is one.
// Returns its end.
double CellMaker::look(const PathPiece& piece, const JointSample& first, Stretch& stretch,
                       CellBounds& bounds) const {
  const bool fine = cells_of_piece_ < kMostFineCells;
  const double coarse = fine ? 0 : (piece.end - piece.begin) / kCoarseCells;
  for (double length = 2 * length_;; length = stretch.length() / 2) {
    // What would remain behind the cell must not be shorter than a cell.
    const bool last = begin_ + length + kShortest > piece.end;
    const double end = last ? piece.end : begin_ + length;
    stretch.look(begin_, first, end);
    bounds = bounds_of(stretch);
    bounds.curvature = piece.curve.curvature_bound(begin_, end, limits_.linear());
    const bool at_end = !first.rates || !stretch.samples()[2].rates;
    const double shortest = std::max(coarse, at_end ? kAtEnd : 2 * kShortest);
    if (stretch.length() <= shortest || is_cell(piece, stretch, bounds)) return end;
  }
}

bool CellMaker::is_cell(const PathPiece& piece, const Stretch& stretch,
                        const CellBounds& bounds) const {
  if (!stretch.agrees()) return false;
  const double speed = limits_.highest_speed(bounds, piece.use);
  if (speed >= kMostOverride * piece.feed) return true;
  if (stretch.length() <= kFewPeriods * limits_.period_s() * speed) return true;
  const auto& samples = stretch.samples();
  return std::all_of(samples.begin(), samples.end(), [&](const JointSample& sample) {
    return speed >=
           (1 - kMostLoss) * limits_.highest_speed(bounds_at(*sample.rates, bounds), piece.use);
  });
}

// From the samples whose rates are determined; from how far the axes go, where none are.
CellBounds CellMaker::bounds_of(const Stretch& stretch) const {
  CellBounds bounds;
  const auto& samples = stretch.samples();
  const AxisVector way = samples[2].joints - samples[0].joints;
  const bool blind = !samples[0].rates && !samples[1].rates && !samples[2].rates;
  for (std::size_t m = 0; m < linkage_->size(); ++m) {
    bounds.driven.first.values[m] = blind ? std::fabs(way.values[m]) / stretch.length()
                                          : bound(stretch, &PathJet::first, &PathJet::second, m);
    bounds.driven.second.values[m] = bound(stretch, &PathJet::second, &PathJet::third, m);
    bounds.driven.third.values[m] = bound_of_third(stretch, m);
  }
  bounds.deviation = deviation_of(stretch);
  return bounds;
}

// Half of what the samples differ by may lie between them.
double CellMaker::deviation_of(const Stretch& stretch) const {
  Range range;
  for (const JointSample& sample : stretch.samples()) {
    if (sample.rates) range.see(deviation_at(sample));
  }
  return std::max(0.0, kALittle * (range.high() + range.width() / 2));
}

// Over the square of a step, from one in which no axis goes far.
double CellMaker::deviation_at(const JointSample& sample) const {
  constexpr double kSmallMove = 1e-6;  // mm, degrees
  const double most = largest(sample.rates->first);
  if (most == 0) return 0;
  const double step = kSmallMove / most;
  AxisVector to = sample.joints;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    to.values[m] += step * sample.rates->first.values[m];
  return linkage_->deviation_mm(sample.joints, to) / (step * step);
}

void CellMaker::add(const PathPiece& piece, double begin, double end, const CellBounds& bounds,
                    const Overrides& overrides, Ring<Cell>& cells) {
  Cell& cell = cells.push();
  cell.piece = next_piece_;
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
