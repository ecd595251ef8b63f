#include "stock/dexel/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr double kMostChords = 1 << 20;

/// Level circles repeat themselves.
ArcWay once_round(ArcWay arc) {
  constexpr double kRound = 2 * std::numbers::pi;
  const bool repeats =
      arc.radius_change == 0 && arc.rise == Vec3{} && std::fabs(arc.turn_rad) > kRound;
  if (repeats) arc.turn_rad = std::copysign(kRound, arc.turn_rad);
  return arc;
}

double chords_of(const ArcWay& arc, double tolerance_mm) {
  const double radius = std::max(std::fabs(arc.radius), std::fabs(arc.radius + arc.radius_change));
  const double turn = std::fabs(arc.turn_rad);
  // Of a spiral the change of radius bends it as well: by 2 turn dr more than a circle.
  const double bend = radius * turn * turn + 2 * turn * std::fabs(arc.radius_change);
  const double count = std::ceil(std::sqrt(bend / (8 * tolerance_mm)));
  return std::max(count, std::ceil(turn / 2));
}

struct Divide {
  Vec3 origin;
  double tolerance_mm;
  std::vector<Stroke>& out;

  void operator()(const StraightWay& way) const {
    out.push_back({way.from - origin, way.to - way.from});
  }
  void operator()(const TurningWay& way) const {
    out.push_back({way.from - origin, way.to - way.from});
  }
  void operator()(const ArcWay& way) const {
    const ArcWay arc = once_round(way);
    const double count = std::max(1.0, std::min(kMostChords, chords_of(arc, tolerance_mm)));
    Vec3 last = point_at(arc, 0) - origin;
    for (double i = 1; i <= count; ++i) {
      const Vec3 next = point_at(arc, i / count) - origin;
      out.push_back({last, next - last});
      last = next;
    }
  }
};

}  // namespace

void append_strokes(const Way& way, Vec3 origin, double tolerance_mm, std::vector<Stroke>& out) {
  std::visit(Divide{origin, tolerance_mm, out}, way);
}

}  // namespace kerf::stock::dexel
