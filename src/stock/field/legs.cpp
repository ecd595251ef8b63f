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

std::vector<StraightLeg> chords(const ArcWay& way, double error_mm) {
  const int n = static_cast<int>(chords_of(way, error_mm));
  std::vector<StraightLeg> legs;
  legs.reserve(static_cast<std::size_t>(n));
  Vec3 from = point_at(way, 0);
  for (int k = 1; k <= n; ++k) {
    const Vec3 to = point_at(way, static_cast<double>(k) / n);
    legs.emplace_back(StraightWay{from, to});
    from = to;
  }
  return legs;
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

bool can_be_legs(const Way& way, double error_mm) {
  if (const auto* straight = std::get_if<StraightWay>(&way)) {
    return is_finite(straight->from) && is_finite(straight->to);
  }
  const auto* arc = std::get_if<ArcWay>(&way);
  if (arc == nullptr || !is_finite(arc->centre) || !is_finite(arc->rise) || !is_finite(arc->e1) ||
      !is_finite(arc->e2) || !std::isfinite(arc->angle_rad)) {
    return false;
  }
  return RingLeg::can_be(*arc) ? std::isfinite(arc->radius) && std::isfinite(arc->turn_rad)
                               : chords_of(*arc, error_mm) <= kMostChords;
}

Legs legs_of(const Way& way, double error_mm) {
  if (const auto* straight = std::get_if<StraightWay>(&way)) return StraightLeg(*straight);
  const ArcWay& arc = std::get<ArcWay>(way);
  if (RingLeg::can_be(arc)) return RingLeg(arc);
  return chords(arc, error_mm);
}

}  // namespace kerf::stock::field
