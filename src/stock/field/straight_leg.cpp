#include "stock/field/straight_leg.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/straight_pieces.hpp"

namespace kerf::stock::field {
namespace {

/// Nearer than this, seen from above, both ends are over the same place.
constexpr double kVertical_mm = 1e-7;

}  // namespace

StraightLeg::StraightLeg(const StraightWay& way)
    : downwards_(way.to.z < way.from.z), box_(bounds(Way(way))) {
  const Vec3& low = downwards_ ? way.to : way.from;
  const Vec3& high = downwards_ ? way.from : way.to;
  x_ = low.x;
  y_ = low.y;
  z_ = low.z;
  const double rise = high.z - low.z;
  const double run =
      std::sqrt((high.x - low.x) * (high.x - low.x) + (high.y - low.y) * (high.y - low.y));
  if (run <= kVertical_mm) {
    height_ = rise;
    return;
  }
  length_ = run;
  dx_ = (high.x - low.x) / run;
  dy_ = (high.y - low.y) / run;
  slope_ = rise / run;
}

StraightLeg::Place StraightLeg::place(double x, double y) const {
  return {(x - x_) * dx_ + (y - y_) * dy_, (y - y_) * dx_ - (x - x_) * dy_};
}

void StraightLeg::lower(const LowerEnvelope& tool, const BlockPoints& points,
                        BlockValues& low) const {
  BlockValues along;
  BlockValues across2;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const double x = points.x[i] - x_;
    const double y = points.y[i] - y_;
    const double u = y * dx_ - x * dy_;
    along[i] = x * dx_ + y * dy_;
    across2[i] = u * u;
  }
  const StraightSlope way{z_, slope_, length_};
  for (const EnvelopePiece& piece : tool.pieces()) lower_by_piece(way, piece, along, across2, low);
}

void StraightLeg::bound(const LowerEnvelope& tool, const BlockRow& row, RowValues& bounds) const {
  const double reach = tool.reach() + row.radius;
  RowValues tip;       // not above the tip while it reaches the block
  RowValues distance;  // of the axis, at least
  for (std::size_t i = 0; i < kTileBlocks; ++i) {
    const double x = row.x[i] - x_;
    const double y = row.y - y_;
    const double along = x * dx_ + y * dy_;
    const double u = y * dx_ - x * dy_;
    const double past = along < 0 ? -along : (along > length_ ? along - length_ : 0.0);
    const double first = along > reach ? along - reach : 0.0;
    tip[i] = z_ - kBoundSafety_mm + slope_ * first;
    distance[i] = std::sqrt(u * u + past * past) - row.radius - kBoundSafety_mm;
  }
  lowest_at(tool, distance, tip, bounds);
}

double StraightLeg::highest_tip(double reach, double x, double y) const {
  const auto [along, across] = place(x, y);
  const double w2 = reach * reach - across * across;
  if (reach < 0 || w2 < 0) return -kNowhere;
  const double last = std::min(length_, along + std::sqrt(w2));
  const double first = std::max(0.0, along - std::sqrt(w2));
  return first <= last ? z_ + slope_ * last + height_ : -kNowhere;
}

double StraightLeg::offset(double x, double y) const {
  const double across = place(x, y).across;
  return downwards_ ? -across : across;
}

double StraightLeg::taken_by_core(double core, double x, double y, double height) const {
  const auto [along, across] = place(x, y);
  const double w2 = core * core - across * across;
  if (w2 < 0) return 0;
  const double last = std::min(length_, along + std::sqrt(w2));
  const double first = std::max(0.0, along - std::sqrt(w2));
  if (first > last) return 0;
  const double begin = downwards_ ? length_ : 0;  // where the move begins
  const bool begins_over = first <= begin && begin <= last;
  const double lowest = z_ + slope_ * first;
  if (begins_over) return std::max(0.0, height - lowest);
  return downwards_ ? std::max(0.0, std::min(height, z_ + slope_ * last) - lowest) : 0.0;
}

}  // namespace kerf::stock::field
