#include "stock/sweep/ball_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::stock {
namespace {

// Of the gap between ball and box, and how often Newton's rule is used to find it.
constexpr double kNone_mm = 1e-9;
constexpr int kSteps = 200;

Vec3 nearest(const Bounds& box, Vec3 p) {
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y),
          std::clamp(p.z, box.low.z, box.high.z)};
}

struct Gap {
  double mm = 0;
  double change = 0;  // mm over the whole way
};

/// Between the centre and the box, which it is outside of.
Gap gap_of(const StraightWay& way, double t, const Bounds& box) {
  const Vec3 p = point_at(way, t);
  const Vec3 from = p - nearest(box, p);
  const double mm = geometry::length(from);
  return {mm, mm > 0 ? geometry::dot(way.to - way.from, from) / mm : 0};
}

/// One axis of a point that goes through a box.
struct Slab {
  double from = 0;
  double way = 0;
  double low = 0;
  double high = 0;
};

std::array<Slab, 3> slabs_of(const StraightWay& way, const Bounds& box) {
  const Vec3 go = way.to - way.from;
  return {{{way.from.x, go.x, box.low.x, box.high.x},
           {way.from.y, go.y, box.low.y, box.high.y},
           {way.from.z, go.z, box.low.z, box.high.z}}};
}

/// It begins in the box: whether it has left it but for kLeft_mm of the nearest face.
bool has_left(const std::array<Slab, 3>& slabs) {
  double depth = HUGE_VAL;
  double inwards = 0;
  for (const Slab& slab : slabs) {
    if (slab.from - slab.low < depth) {
      depth = slab.from - slab.low;
      inwards = slab.way;
    }
    if (slab.high - slab.from < depth) {
      depth = slab.high - slab.from;
      inwards = -slab.way;
    }
  }
  return depth <= kLeft_mm && inwards <= 0;
}

std::optional<double> first_touch_of_point(const StraightWay& way, const Bounds& box) {
  const std::array<Slab, 3> slabs = slabs_of(way, box);
  double in = -HUGE_VAL;
  double out = HUGE_VAL;
  for (const Slab& slab : slabs) {
    if (slab.way == 0) {
      if (slab.from < slab.low || slab.from > slab.high) return std::nullopt;
      continue;
    }
    const double a = (slab.low - slab.from) / slab.way;
    const double b = (slab.high - slab.from) / slab.way;
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  if (in > out || out < 0 || in > 1) return std::nullopt;
  if (in > 0) return in;
  if (has_left(slabs)) return std::nullopt;
  return 0.0;
}

}  // namespace

Bounds bounds(const BallWay& ball) {
  const Bounds way = bounds(Way(ball.way));
  const Vec3 all{ball.radius_mm, ball.radius_mm, ball.radius_mm};
  return {way.low - all, way.high + all};
}

// The gap to a convex body is a convex function of t: from the left, Newton's rule comes near
// without ever going past.
std::optional<double> first_touch(const BallWay& ball, const Bounds& box) {
  if (ball.radius_mm <= 0) return first_touch_of_point(ball.way, box);
  Gap gap = gap_of(ball.way, 0, box);
  const double overlap = ball.radius_mm - gap.mm;
  if (overlap > kLeft_mm) return 0.0;
  double t = 0;
  for (int i = 0; i < kSteps; ++i) {
    if (gap.change >= 0) return std::nullopt;
    if (gap.mm - ball.radius_mm <= kNone_mm) return t;
    t -= (gap.mm - ball.radius_mm) / gap.change;
    if (t > 1) return std::nullopt;
    gap = gap_of(ball.way, t, box);
  }
  return t;
}

}  // namespace kerf::stock
