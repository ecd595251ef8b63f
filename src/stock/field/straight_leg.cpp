#include "stock/field/straight_leg.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/level_pieces.hpp"

namespace kerf::stock::field {
namespace {

/// Nearer than this, seen from above, both ends are over the same place.
constexpr double kVertical_mm = 1e-7;

float narrow(double value) { return static_cast<float>(value); }

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

StraightLeg::View StraightLeg::view(const LowerEnvelope& tool, double base, HalfBlock half,
                                    const LaneWork& lanes) const {
  const double safety = bound_safety(length_ + tool.reach());
  const double abs_dx = std::abs(dx_);
  const double abs_dy = std::abs(dy_);
  View view(tool, lanes);
  StraightSight& sight = view.sight_;
  sight = {.x = x_,
           .y = y_,
           .dx = narrow(dx_),
           .dy = narrow(dy_),
           .z = narrow(z_ - base),
           .slope = narrow(slope_),
           .length = narrow(length_),
           .left = downwards_ ? -1.0F : 1.0F,
           .begins_behind = begins_ == Begins::behind_itself,
           .behind = behind_of(tool),
           .half_along = narrow(half.x * abs_dx + half.y * abs_dy + safety),
           .half_across = narrow(half.x * abs_dy + half.y * abs_dx + safety),
           .lowest_z = narrow(z_ - base - safety)};
  sight.reach = narrow(tool.reach()) + sight.half_along;
  sight.lean2 = sight.slope * sight.slope / (1 + sight.slope * sight.slope);
  if (const LowerEnvelope::Round* const round = tool.round()) {
    const float core = std::max(0.0F, narrow(round->core));
    view.floor_ = {.reach2 = narrow(tool.reach() * tool.reach() * (1 + 1e-6)),
                   .core = core,
                   .base = narrow(round->core) - core,
                   .z = narrow(round->z),
                   .radius2 = narrow(round->radius * round->radius)};
  }
  return view;
}

void StraightLeg::View::meets(const BlockGrid& grid, BlockMasks& met) const {
  if (tool_->round() != nullptr) return lanes_->meets(sight_, floor_, grid, met);
  RowValues tip;
  RowValues distance;
  RowValues lowest;
  lowest.fill(kNowhere);
  for (std::size_t row = grid.first_y; row < grid.end_y; ++row) {
    lanes_->places(sight_, grid, row, tip, distance);
    lowest_at(*tool_, grid, distance, tip, lowest);
    met[row] = lanes_->below(lowest.data(), grid.tops + row * kTileBlocks);
  }
}

/// Up a slope the lowest place for a column is never behind it. Down one it is ahead by no more
/// than the reach of the tool, and for a round one by no more than its core and the w m / √(1 + m²)
/// of its ball (lane_pieces.hpp).
Behind StraightLeg::behind_of(const LowerEnvelope& tool) const {
  Behind none;
  if (begins_ == Begins::afresh || length_ == 0) return none;
  if (!downwards_) {
    none.before = 0;
    return none;
  }
  const LowerEnvelope::Round* round = tool.round();
  if (round == nullptr) {
    none.after = narrow(length_ + tool.reach());
    return none;
  }
  const double core = std::max(0.0, round->core);
  const double lean = slope_ * slope_ / (1 + slope_ * slope_);
  return {.after = narrow(length_ + core),
          .core = narrow(core),
          .lean = narrow(lean),
          .lean2 = narrow(lean * round->radius * round->radius)};
}

/// How far behind the beginning of the way columns may be that are not behind in the sense above.
double StraightLeg::most_behind(const LowerEnvelope& tool) const {
  if (begins_ == Begins::afresh || length_ == 0) return tool.reach();
  if (!downwards_) return 0;
  const LowerEnvelope::Round* round = tool.round();
  if (round == nullptr) return tool.reach();
  const double sine = slope_ / std::sqrt(1 + slope_ * slope_);
  return std::max(0.0, round->core) + sine * round->radius;
}

/// A half of the tool at the beginning: in the direction a it reaches as far as all of it, unless
/// that place is more than `most` behind; then its farthest one is where the chord ends that is so
/// far behind. On the rest of the way it goes no farther.
Bounds StraightLeg::reached(const LowerEnvelope& tool) const {
  const double safety = bound_safety(length_ + tool.reach());
  const double reach = tool.reach() + safety;
  const double most = std::min(reach, most_behind(tool) + safety);
  const double chord = std::sqrt(reach * reach - most * most);
  const double sense = downwards_ ? -1 : 1;
  const auto beyond = [&](double along, double across) {  // of a, to the way
    return -reach * along <= most ? reach : chord * std::abs(across) - most * along;
  };
  const double x = sense * dx_;
  const double y = sense * dy_;
  const Vec3 low{x > 0 ? beyond(-x, y) : reach, y > 0 ? beyond(-y, x) : reach, 0};
  const Vec3 high{x < 0 ? beyond(x, y) : reach, y < 0 ? beyond(y, x) : reach, 0};
  return {box_.low - low, box_.high + high};
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
