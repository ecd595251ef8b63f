#include "stock/field/straight_leg.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/straight_pieces.hpp"

namespace kerf::stock::field {
namespace {

/// Nearer than this, seen from above, both ends are over the same place.
constexpr double kVertical_mm = 1e-7;

}  // namespace

/// Columns of a block as seen from the lower end.
struct StraightLeg::Offsets {
  Offsets(const StraightLeg& leg, const BlockPoints& points)
      : dx(static_cast<float>(leg.dx_)), dy(static_cast<float>(leg.dy_)) {
    for (std::size_t i = 0; i < kBlockSide; ++i) {
      x[i] = static_cast<float>(points.x[i] - leg.x_);
      y[i] = static_cast<float>(points.y[i] - leg.y_);
    }
  }
  float x[kBlockSide];
  float y[kBlockSide];
  float dx, dy;
};

StraightLeg::StraightLeg(const StraightWay& way, Begins begins)
    : begins_(begins), downwards_(way.to.z < way.from.z), box_(bounds(Way(way))) {
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

void StraightLeg::lower(const LowerEnvelope& tool, const BlockPoints& points, double base,
                        BlockValues& low) const {
  const Offsets at(*this, points);
  BlockValues along;
  BlockValues across2;
  for (std::size_t j = 0; j < kBlockSide; ++j) {
    for (std::size_t i = 0; i < kBlockSide; ++i) {
      const float u = at.y[j] * at.dx - at.x[i] * at.dy;
      along[j * kBlockSide + i] = at.x[i] * at.dx + at.y[j] * at.dy;
      across2[j * kBlockSide + i] = u * u;
    }
  }
  if (length_ == 0) {  // no direction is better than another
    along.fill(0);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      const float x = at.x[i % kBlockSide];
      const float y = at.y[i / kBlockSide];
      across2[i] = x * x + y * y;
    }
  }
  if (begins_ == Begins::behind_itself) leave_out_behind(tool, along, across2);
  const StraightSlope way{static_cast<float>(z_ - base), static_cast<float>(slope_),
                          static_cast<float>(length_)};
  for (const EnvelopePiece& piece : tool.pieces()) lower_by_piece(way, piece, along, across2, low);
}

/// Columns behind have been cut, and rounding is not to cut them once more: otherwise what a block
/// that is looked at for another column holds would depend on where blocks are.
void StraightLeg::leave_out_behind(const LowerEnvelope& tool, const BlockValues& along,
                                   BlockValues& across2) const {
  const Behind behind = behind_of(tool);
  const Lanes far = all(kNowhere);
  for (std::size_t i = 0; i < kBlockCells; i += kLanes) {
    const Lanes a = load(&along[i]);
    const Lanes u2 = load(&across2[i]);
    Lanes after = all(behind.after);
    if (behind.lean > 0) {
      const Lanes out = larger(root(u2) - behind.core, Lanes{});
      after = after + root(behind.lean2 - behind.lean * out * out);
    }
    store(((a < all(behind.before)) | (a > after)) ? far : u2, &across2[i]);
  }
}

/// Every block as a rectangle along and across the way that holds its columns.
void StraightLeg::bound(const LowerEnvelope& tool, const BlockRow& row, double base,
                        RowValues& bounds) const {
  const double safety = bound_safety(length_ + tool.reach());
  const auto dx = static_cast<float>(dx_);
  const auto dy = static_cast<float>(dy_);
  const double abs_dx = std::abs(dx_);
  const double abs_dy = std::abs(dy_);
  const auto half_along = static_cast<float>(row.half_x * abs_dx + row.half_y * abs_dy + safety);
  const auto half_across = static_cast<float>(row.half_x * abs_dy + row.half_y * abs_dx + safety);
  const float reach = static_cast<float>(tool.reach()) + half_along;
  const auto base_z = static_cast<float>(z_ - base - safety);
  const auto from_x = static_cast<float>(x_ - row.origin_x);
  const Lanes none{};
  const auto slope = static_cast<float>(slope_);
  const auto length = static_cast<float>(length_);
  const Lanes y = all(static_cast<float>(row.y - y_));
  const Behind behind = behind_of(tool);
  RowValues tip;       // not above the tip while it reaches the block
  RowValues distance;  // of the axis, at least
  for (std::size_t i = row.first; i < row.last; i += kLanes) {
    const Lanes x = load(&row.x[i]) - from_x;
    const Lanes along = x * dx + y * dy;
    const Lanes beside = y * dx - x * dy;
    const Lanes u = larger(larger(beside, -beside) - half_across, none);
    const Lanes past = larger(larger(-along, along - length) - half_along, none);
    Lanes after = all(behind.after);
    if (behind.lean > 0) {
      const Lanes out = larger(u - behind.core, none);
      after = after + root(behind.lean2 - behind.lean * out * out);
    }
    const Lanes z = base_z + slope * larger(along - reach, none);
    const auto is_behind = (along + half_along < all(behind.before)) | (along - half_along > after);
    store(is_behind ? all(kNowhere) : z, &tip[i]);
    store(root(u * u + past * past), &distance[i]);
  }
  lowest_at(tool, row, distance, tip, bounds);
}

/// Up a slope the lowest place for a column is never behind it. Down one it is ahead by no more
/// than the reach of the tool, and for a round one by no more than its core and the w m / √(1 + m²)
/// of its ball (straight_pieces.cpp).
StraightLeg::Behind StraightLeg::behind_of(const LowerEnvelope& tool) const {
  Behind none{-kNowhere, kNowhere, 0, 0, 0};
  if (begins_ == Begins::afresh || length_ == 0) return none;
  if (!downwards_) {
    none.before = 0;
    return none;
  }
  const LowerEnvelope::Round* round = tool.round();
  if (round == nullptr) {
    none.after = static_cast<float>(length_ + tool.reach());
    return none;
  }
  const double core = std::max(0.0, round->core);
  const double lean = slope_ * slope_ / (1 + slope_ * slope_);
  return {-kNowhere, static_cast<float>(length_ + core), static_cast<float>(core),
          static_cast<float>(lean), static_cast<float>(lean * round->radius * round->radius)};
}

double StraightLeg::highest_tip(double reach, double x, double y) const {
  const auto [along, across] = place(x, y);
  const double w2 = reach * reach - across * across;
  if (reach < 0 || w2 < 0) return -kNowhere;
  const double last = std::min(length_, along + std::sqrt(w2));
  const double first = std::max(0.0, along - std::sqrt(w2));
  return first <= last ? z_ + slope_ * last + height_ : -kNowhere;
}

void StraightLeg::offsets(const BlockPoints& points, BlockValues& offsets) const {
  const Offsets at(*this, points);
  const float left = downwards_ ? -1 : 1;
  for (std::size_t j = 0; j < kBlockSide; ++j) {
    for (std::size_t i = 0; i < kBlockSide; ++i) {
      offsets[j * kBlockSide + i] = length_ > 0 ? left * (at.y[j] * at.dx - at.x[i] * at.dy)
                                                : std::sqrt(at.x[i] * at.x[i] + at.y[j] * at.y[j]);
    }
  }
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
