#include "stock/field/ring_leg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stock/field/level_pieces.hpp"

namespace kerf::stock::field {
namespace {

constexpr double kLevel_mm = 1e-9;

double far_from(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace

bool RingLeg::can_be(const ArcWay& way) {
  const auto none = [](double v) { return std::abs(v) <= kLevel_mm; };
  return none(way.rise.x) && none(way.rise.y) && none(way.rise.z) && none(way.radius_change) &&
         none(way.radius * way.e1.z) && none(way.radius * way.e2.z) && way.radius >= 0 &&
         way.radius <= kLongestLeg_mm;
}

RingLeg::RingLeg(const ArcWay& way)
    : centre_{way.centre.x, way.centre.y},
      e1_{way.e1.x, way.e1.y},
      e2_{way.e2.x, way.e2.y},
      z_(way.centre.z),
      radius_(way.radius),
      is_reflex_(std::abs(way.turn_rad) > std::numbers::pi),
      is_full_(std::abs(way.turn_rad) >= 2 * std::numbers::pi),
      box_(bounds(Way(way))) {
  const auto direction = [](double angle) {
    const math::SineCosine at = math::sine_cosine(angle);
    return Flat{at.cosine, at.sine};
  };
  first_ = direction(way.angle_rad);
  last_ = direction(way.angle_rad + way.turn_rad);
  if (way.turn_rad < 0) std::swap(first_, last_);
  const Vec3 begin = point_at(way, 0);
  const Vec3 end = point_at(way, 1);
  begin_ = {begin.x, begin.y};
  end_ = {end.x, end.y};
  const double sense = e1_.x * e2_.y - e1_.y * e2_.x;
  left_ = (sense > 0) == (way.turn_rad > 0) ? 1 : -1;
}

bool RingLeg::is_beside(double x, double y) const {
  const double u = x * e1_.x + y * e1_.y;
  const double v = x * e2_.x + y * e2_.y;
  const double after_first = first_.x * v - first_.y * u;
  const double before_last = u * last_.y - v * last_.x;
  const bool both = after_first >= 0 && before_last >= 0;
  const bool one = after_first >= 0 || before_last >= 0;
  return is_full_ || (is_reflex_ ? one : both);
}

double RingLeg::distance(double x, double y) const {
  const double dx = x - centre_.x;
  const double dy = y - centre_.y;
  if (is_beside(dx, dy)) return std::abs(far_from(dx, dy) - radius_);
  return std::min(far_from(x - begin_.x, y - begin_.y), far_from(x - end_.x, y - end_.y));
}

void RingLeg::View::lower(const BlockPoints& points, BlockValues& low) const {
  BlockValues from;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    from[i] = static_cast<float>(leg_->distance(points.x_of(i), points.y_of(i)));
  }
  lower_level(*tool_, static_cast<float>(leg_->z_ - base_), from, low);
}

std::size_t RingLeg::View::look(const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                                std::size_t* lowered) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const BlockPoints points = tile.points(blocks[k]);
    looks[k].low.fill(kNowhere);
    lower(points, looks[k].low);
    leg_->offsets(points, looks[k].offsets);
    const float* const heights = tile.heights + std::ptrdiff_t{blocks[k]} * kBlockCells;
    if (lane_work().below(looks[k].low.data(), heights) != 0) lowered[count++] = k;
  }
  return count;
}

void RingLeg::View::meets(const BlockGrid& grid, BlockMasks& met) const {
  const double safety = bound_safety(leg_->radius_ + tool_->reach());
  const double radius = far_from(grid.half.x, grid.half.y);
  RowValues from;
  RowValues tip;
  RowValues lowest;
  tip.fill(static_cast<float>(leg_->z_ - base_ - safety));
  lowest.fill(kNowhere);
  for (std::size_t row = grid.first_y; row < grid.end_y; ++row) {
    for (std::size_t i = grid.first_x; i < grid.end_x; ++i) {
      const double x = grid.origin_x + static_cast<double>(grid.x[i]);
      from[i] = static_cast<float>(leg_->distance(x, grid.y[row]) - radius - safety);
    }
    lowest_at(*tool_, grid, from, tip, lowest);
    met[row] = lane_work().below(lowest.data(), grid.tops + row * kTileBlocks);
  }
}

double RingLeg::highest_tip(double reach, double x, double y) const {
  return distance(x, y) <= reach ? z_ : -kNowhere;
}

void RingLeg::offsets(const BlockPoints& points, BlockValues& offsets) const {
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const double from = far_from(points.x_of(i) - centre_.x, points.y_of(i) - centre_.y);
    offsets[i] = static_cast<float>(left_ * (radius_ - from));
  }
}

double RingLeg::taken_by_core(double core, double x, double y, double height) const {
  const bool begins_over = far_from(x - begin_.x, y - begin_.y) <= core;
  return begins_over ? std::max(0.0, height - z_) : 0.0;
}

}  // namespace kerf::stock::field
