#include "stock/sheet/trace.hpp"

#include <numbers>

#include "math/math.hpp"

namespace kerf::stock::sheet {
namespace {

using std::numbers::pi;

// A way that nobody could follow is not divided without end.
constexpr double kMostParts = 100'000;
// A circle whose plane is tilted by less is level: what rounding leaves.
constexpr double kLevel = 1e-12;

Vec2 flat(Vec3 place) { return {place.x, place.y}; }
Vec2 on_circle(double angle_rad) {
  const auto [s, c] = math::sine_cosine(angle_rad);
  return {c, s};
}

double parts_for(double deviation, double tolerance) {
  return std::clamp(std::ceil(deviation / tolerance), 1.0, kMostParts);
}

bool is_level(const ArcWay& way) {
  return std::fabs(way.e1.z) < kLevel && std::fabs(way.e2.z) < kLevel &&
         math::hypot(way.rise.x, way.rise.y) < kLevel;
}

/// A spiral as arcs, each with the radius of its middle.
void add_level(const ArcWay& way, double tolerance, std::vector<Trace>& traces) {
  const bool is_left = way.e1.x * way.e2.y - way.e1.y * way.e2.x > 0;
  const double side = is_left ? 1 : -1;
  const double zero = math::atan2(way.e1.y, way.e1.x);
  const double parts = parts_for(std::fabs(way.radius_change) / 2, tolerance);
  for (double i = 0; i < parts; ++i) {
    const double radius = way.radius + way.radius_change * ((i + 0.5) / parts);
    const double angle = way.angle_rad + way.turn_rad * (i / parts);
    if (radius > 0)
      traces.push_back(
          round(flat(way.centre), radius, zero + side * angle, side * way.turn_rad / parts));
  }
}

void add_divided(const ArcWay& way, double tolerance, std::vector<Trace>& traces) {
  const double radius = std::max(way.radius, way.radius + way.radius_change);
  const double bend =
      radius * way.turn_rad * way.turn_rad + 2 * std::fabs(way.radius_change * way.turn_rad);
  const double parts = std::min(kMostParts, std::ceil(std::sqrt(bend / (8 * tolerance))) + 1);
  Vec2 from = flat(point_at(way, 0));
  for (double i = 1; i <= parts; ++i) {
    const Vec2 to = flat(point_at(way, i / parts));
    traces.push_back(straight(from, to));
    from = to;
  }
}

void add(const StraightWay& way, double, std::vector<Trace>& traces) {
  traces.push_back(straight(flat(way.from), flat(way.to)));
}

void add(const TurningWay& way, double, std::vector<Trace>& traces) {
  traces.push_back(straight(flat(way.from), flat(way.to)));
}

void add(const ArcWay& way, double tolerance, std::vector<Trace>& traces) {
  if (is_level(way)) {
    add_level(way, tolerance, traces);
  } else {
    add_divided(way, tolerance, traces);
  }
}

}  // namespace

Trace straight(Vec2 from, Vec2 to) { return {from, to}; }

Trace round(Vec2 centre, double radius, double angle_rad, double turn_rad) {
  const bool is_whole = std::fabs(turn_rad) >= 2 * pi;
  const double turn = std::clamp(turn_rad, -2 * pi, 2 * pi);
  Trace arc;
  arc.from = centre + radius * on_circle(angle_rad);
  arc.to = is_whole ? arc.from : centre + radius * on_circle(angle_rad + turn);
  arc.radius = radius;
  arc.centre = centre;
  arc.middle = on_circle(angle_rad + turn / 2);
  arc.cos_half = is_whole ? -2 : math::cos(turn / 2);
  arc.turn_rad = turn;
  return arc;
}

double distance(const Trace& trace, Vec2 place) {
  return trace.radius > 0 ? DistanceToArc(trace)(place.u, place.v)
                          : DistanceToLine(trace.from, trace.to)(place.u, place.v);
}

Box extents(const Trace& trace) {
  Box box;
  box.take(trace.from);
  box.take(trace.to);
  if (!(trace.radius > 0)) return box;
  for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    if (dot(way, trace.middle) >= trace.cos_half) box.take(trace.centre + trace.radius * way);
  }
  return box;
}

Trace part(const Trace& trace, double share) {
  if (!(trace.radius > 0))
    return straight(trace.from, trace.from + share * (trace.to - trace.from));
  const Vec2 out = trace.from - trace.centre;
  return round(trace.centre, trace.radius, math::atan2(out.v, out.u), share * trace.turn_rad);
}

double length(const Trace& trace) {
  return trace.radius > 0 ? trace.radius * std::fabs(trace.turn_rad)
                          : geometry::length(trace.to - trace.from);
}

void add_traces(const Way& way, double tolerance_mm, std::vector<Trace>& traces) {
  std::visit([&](const auto& one) { add(one, tolerance_mm, traces); }, way);
}

}  // namespace kerf::stock::sheet
