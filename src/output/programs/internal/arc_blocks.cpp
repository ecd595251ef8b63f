#include "output/programs/internal/arc_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "motion/space_arc_path.hpp"
#include "output/programs/internal/round_way.hpp"

namespace kerf::output {
namespace {

using namespace motion;

constexpr double kMostRadius_mm = 99999;  // controls keep I, J, K to so many digits
constexpr double kHalfDigit_mm = 0.5e-4;  // of the output

/// A plane arc from where the posted program stands, with the digits that it will have.
struct Posted {
  Posted(const base::TipPoint& at, const Arc& arc, const PlaneAxes& plane)
      : from(post_rounded(plane.project(at))),
        to(post_rounded(plane.project(arc.to))),
        offset(post_rounded(geometry::Vec2{arc.center[0], arc.center[1]} - from)),
        clockwise(arc.direction == Direction::clockwise) {}

  [[nodiscard]] bool is_spiral() const {
    return std::fabs(length(offset) - length(to - from - offset)) > ArcBlocks::kRadiusTolerance_mm;
  }
  /// A full circle where it ends at its start.
  [[nodiscard]] double sweep_rad() const {
    return geometry::sweep_rad(from, to, from + offset, clockwise);
  }

  geometry::Vec2 from, to;
  geometry::Vec2 offset;  // of the centre: I, J, K
  bool clockwise;
};

// How much the normal of a circle leaves that of a plane, as cosine.
double upright_in(Plane plane, const geometry::SpaceArc& circle) {
  const geometry::Vec3& e3 = circle.e3();
  return plane == Plane::xy ? e3.z : plane == Plane::zx ? e3.y : e3.x;
}

std::array<double, 2> centre_in(Plane plane, const geometry::SpaceArc& circle) {
  const geometry::Vec3& centre = circle.centre();
  if (plane == Plane::xy) return {centre.x, centre.y};
  if (plane == Plane::zx) return {centre.z, centre.x};
  return {centre.y, centre.z};
}

}  // namespace

// Each rises by its share of the way along the other axes, and closes in the plane: what the radius
// changes by, which is within the control's tolerance, is left to the rest of the arc.
void ArcBlocks::full_circles(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const double rest_rad =
      geometry::sweep_rad(plane.project(moves_.at()), plane.project(arc.to),
                          {arc.center[0], arc.center[1]}, arc.direction == Direction::clockwise);
  const double turns = arc.turns + rest_rad / (2 * std::numbers::pi);
  const base::TipPoint from = moves_.at();
  Arc circle = arc;
  for (unsigned turn = 1; turn <= arc.turns; ++turn) {
    circle.to = from;
    for (std::size_t i = 0; i < moves_.axes().count(); ++i) {
      const base::Axis axis{static_cast<std::uint8_t>(i)};
      if (!plane.contains(axis)) circle.to[axis] += (arc.to[axis] - from[axis]) * turn / turns;
    }
    sweep(circle, plane, per_minute);
  }
}

void ArcBlocks::sweep(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  moves_.arc(plane, arc, Posted(moves_.at(), arc, plane).offset, per_minute);
}

void ArcBlocks::write(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, moves_.axes());
  if (!plane) return;
  const geometry::Vec2 from = plane->project(moves_.at());
  const geometry::Vec2 to = plane->project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == Direction::clockwise;
  const double length = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const double per_minute = moves_.per_minute(arc.feed, length);
  if (const auto rise = flat_rise(arc, *plane)) return flat_arc(arc, *plane, *rise);
  if (Posted(moves_.at(), arc, *plane).is_spiral()) return spiral(arc, *plane, per_minute);
  full_circles(arc, *plane, per_minute);
  rest_of_turn(arc, *plane, geometry::sweep_rad(from, to, centre, clockwise), per_minute);
}

// Less than a digit is enough to turn an arc that is next to nothing into a whole circle, or one
// that is nearly whole into nothing.
void ArcBlocks::rest_of_turn(const Arc& arc, const PlaneAxes& plane, double sweep_rad,
                             double per_minute) {
  const double posted_rad = Posted(moves_.at(), arc, plane).sweep_rad();
  if (posted_rad > sweep_rad + std::numbers::pi) return moves_.line(arc.to, per_minute);
  if (posted_rad > sweep_rad - std::numbers::pi) return sweep(arc, plane, per_minute);
  Arc whole = arc;
  plane.place(whole.to, plane.project(moves_.at()));
  sweep(whole, plane, per_minute);
  moves_.line(arc.to, per_minute);
}

void ArcBlocks::spiral(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const RoundWay way(plane, moves_.at(), arc);
  const double count = way.chord_count(kChordTolerance_mm);
  for (double n = 1; n <= count; ++n) moves_.line(way.at(n / count), per_minute);
}

// How high an arc rises above its chord, where its centre is too far away to be written.
std::optional<double> ArcBlocks::flat_rise(const Arc& arc, const PlaneAxes& plane) const {
  const geometry::Vec2 from = plane.project(moves_.at());
  const geometry::Vec2 to = plane.project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const double radius = length(centre - from);
  const double half = length(to - from) / 2;
  if (radius <= kMostRadius_mm || half == 0 || arc.turns > 0) return std::nullopt;
  const bool clockwise = arc.direction == Direction::clockwise;
  if (geometry::sweep_rad(from, to, centre, clockwise) >= std::numbers::pi) return std::nullopt;
  return half * half / (radius + std::sqrt((radius - half) * (radius + half)));
}

// Chords, of the arc through the point half way.
void ArcBlocks::flat_arc(const Arc& arc, const PlaneAxes& plane, double rise) {
  if (rise < kChordTolerance_mm) return moves_.straight(arc.to, arc.feed);
  const geometry::Vec2 way = plane.project(arc.to) - plane.project(moves_.at());
  const double side = (arc.direction == Direction::clockwise ? -rise : rise) / length(way);
  SpaceArc flat{.to = arc.to, .via = moves_.at(), .feed = arc.feed};
  for (std::size_t i = 0; i < moves_.axes().count(); ++i)
    flat.via.values[i] += (arc.to.values[i] - moves_.at().values[i]) / 2;
  flat.via[plane.first] += side * way.v;
  flat.via[plane.second] -= side * way.u;
  write(flat);
}

// Whether nothing moves but the two axes of the plane.
bool ArcBlocks::stays_in(const PlaneAxes& plane, const SpaceArc& arc) const {
  for (std::size_t i = 0; i < moves_.axes().count(); ++i) {
    if (plane.contains(base::Axis{static_cast<std::uint8_t>(i)})) continue;
    const double stays = post_rounded(moves_.at().values[i]);
    const bool leaves = post_rounded(arc.via.values[i]) != stays ||
                        post_rounded(arc.to.values[i]) != stays ||
                        (arc.full_circle && post_rounded(arc.second_via.values[i]) != stays);
    if (leaves) return false;
  }
  return true;
}

// Within half a digit of the output the arc lies in the plane, and nothing else moves.
std::optional<Arc> ArcBlocks::plane_arc(const SpaceArc& arc, const geometry::SpaceArc& circle,
                                        Plane plane) const {
  const auto axes = plane_axes(plane, moves_.axes());
  if (!axes || circle.radius() > kMostRadius_mm || !stays_in(*axes, arc)) return std::nullopt;
  const double upright = upright_in(plane, circle);
  const double tilt = std::sqrt(std::max(0.0, (1 - upright) * (1 + upright)));
  if (2 * circle.radius() * tilt > kHalfDigit_mm) return std::nullopt;
  return Arc{.to = arc.to,
             .center = centre_in(plane, circle),
             .feed = arc.feed,
             .plane = plane,
             .direction = upright > 0 ? Direction::counterclockwise : Direction::clockwise};
}

void ArcBlocks::write(const SpaceArc& arc) {
  const SpaceArcPath path(moves_.axes(), moves_.at(), arc);
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    if (const auto flat = plane_arc(arc, path.circle(), plane)) return write(*flat);
  }
  const double most_rad = geometry::chord_angle_rad(path.circle().radius(), kChordTolerance_mm);
  const double per_minute = moves_.per_minute(arc.feed, path.circle().length());
  path.chords(most_rad, [&](const base::TipPoint& to) { moves_.line(to, per_minute); });
}

}  // namespace kerf::output
