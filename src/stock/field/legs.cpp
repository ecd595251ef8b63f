#include "stock/field/legs.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::stock::field {
namespace {

/// P(t) leaves a chord over Δt by |P″| Δt² / 8 at most.
double chords_of(const ArcWay& way, double error_mm) {
  const double radius = std::max(std::abs(way.radius), std::abs(way.radius + way.radius_change));
  const double bend =
      radius * way.turn_rad * way.turn_rad + 2 * std::abs(way.radius_change * way.turn_rad);
  return std::max(1.0, std::ceil(std::sqrt(bend / (8 * error_mm))));
}

/// Behind itself from the second on: the one before ends where it begins.
std::vector<StraightLeg> chords(const auto& way, double n, StraightLeg::Begins begins) {
  std::vector<StraightLeg> legs;
  legs.reserve(static_cast<std::size_t>(n));
  Vec3 from = point_at(way, 0);
  for (double k = 1; k <= n; ++k) {
    const Vec3 to = point_at(way, k / n);
    legs.emplace_back(StraightWay{from, to}, begins);
    begins = StraightLeg::Begins::behind_itself;
    from = to;
  }
  return legs;
}

double legs_in(const StraightWay& way) {
  return std::max(1.0, std::ceil(length(Way(way)) / kLongestLeg_mm));
}
double legs_in(const ArcWay& way, double error_mm) {
  return std::max(chords_of(way, error_mm), std::ceil(length(Way(way)) / kLongestLeg_mm));
}

bool is_near(double v) { return std::abs(v) <= kFarthest_mm; }
bool is_near(Vec3 v) { return is_near(v.x) && is_near(v.y) && is_near(v.z); }
bool is_near(const StraightWay& way) { return is_near(way.from) && is_near(way.to); }
bool is_near(const ArcWay& way) {
  return is_near(way.centre) && is_near(way.rise) && is_near(way.e1) && is_near(way.e2) &&
         is_near(way.radius) && is_near(way.radius_change) && is_near(way.angle_rad) &&
         is_near(way.turn_rad);
}

}  // namespace

bool can_be_legs(const Way& way, double error_mm) {
  if (const auto* straight = std::get_if<StraightWay>(&way)) return is_near(*straight);
  const auto* arc = std::get_if<ArcWay>(&way);
  return arc != nullptr && is_near(*arc) &&
         (RingLeg::can_be(*arc) || legs_in(*arc, error_mm) <= kMostChords);
}

Legs legs_of(const Way& way, double error_mm, StraightLeg::Begins begins) {
  if (const auto* straight = std::get_if<StraightWay>(&way)) {
    const double n = legs_in(*straight);
    if (n > 1) return chords(*straight, n, begins);
    return StraightLeg(*straight, begins);
  }
  const ArcWay& arc = std::get<ArcWay>(way);
  if (RingLeg::can_be(arc)) return RingLeg(arc);
  return chords(arc, legs_in(arc, error_mm), begins);
}

}  // namespace kerf::stock::field
