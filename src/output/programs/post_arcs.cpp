#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/arc.hpp"
#include "motion/feed.hpp"
#include "motion/space_arc_path.hpp"
#include "output/programs/internal/round_way.hpp"
#include "output/programs/post.hpp"

namespace kerf::output {
namespace {

using namespace motion;

constexpr double kMostRadius_mm = 99999;  // controls keep I, J, K to so many digits
constexpr double kHalfDigit_mm = 0.5e-4;  // of the output

}  // namespace

/// A plane arc from where the posted program stands, with the digits that it will have.
struct Post::Posted {
  Posted(const Post& post, const Arc& arc, const PlaneAxes& plane)
      : from(rounded(plane.project(post.at_))),
        to(rounded(plane.project(arc.to))),
        offset(rounded(geometry::Vec2{arc.center[0], arc.center[1]} - from)),
        clockwise(arc.direction == Direction::clockwise) {}

  static geometry::Vec2 rounded(geometry::Vec2 point) {
    return {post_rounded(point.u), post_rounded(point.v)};
  }
  [[nodiscard]] bool is_spiral() const {
    return std::fabs(length(offset) - length(to - from - offset)) > kRadiusTolerance_mm;
  }
  /// A full circle where it ends at its start.
  [[nodiscard]] double sweep_rad() const {
    return geometry::sweep_rad(from, to, from + offset, clockwise);
  }

  geometry::Vec2 from, to;
  geometry::Vec2 offset;  // of the centre: I, J, K
  bool clockwise;
};

void Post::select_plane(Plane plane) {
  if (plane == plane_) return;
  plane_ = plane;
  feed_ = -1;  // is said again: not every control keeps it
  block_.code(plane == Plane::xy ? "G17" : plane == Plane::zx ? "G18" : "G19");
  end_block();
}

// Each rises by its share of the way along the other axes, and closes in the plane: what the radius
// changes by, which is within the control's tolerance, is left to the rest of the arc.
void Post::full_circles(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const double rest_rad =
      geometry::sweep_rad(plane.project(at_), plane.project(arc.to), {arc.center[0], arc.center[1]},
                          arc.direction == Direction::clockwise);
  const double turns = arc.turns + rest_rad / (2 * std::numbers::pi);
  const base::TipPoint from = at_;
  Arc circle = arc;
  for (unsigned turn = 1; turn <= arc.turns; ++turn) {
    circle.to = from;
    for (std::size_t i = 0; i < axes_.count(); ++i) {
      const base::Axis axis{static_cast<std::uint8_t>(i)};
      if (!plane.contains(axis)) circle.to[axis] += (arc.to[axis] - from[axis]) * turn / turns;
    }
    sweep(circle, plane, per_minute);
  }
}

// At most a turn; to where it starts it is a whole one, which controls want to be told.
void Post::sweep(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const Posted posted(*this, arc, plane);
  select_plane(arc.plane);
  modal_.clear();
  words(arc.direction == Direction::clockwise ? "G2" : "G3", arc.to);
  if (posted.from == posted.to) {
    block_.number(axes_[plane.first].letter, posted.to.u);
    block_.number(axes_[plane.second].letter, posted.to.v);
  }
  block_.number(plane.first_offset, posted.offset.u);
  block_.number(plane.second_offset, posted.offset.v);
  feed(per_minute);
  end_block();
}

void Post::act(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  if (!plane) return;
  const geometry::Vec2 from = plane->project(at_);
  const geometry::Vec2 to = plane->project(arc.to);
  const geometry::Vec2 centre{arc.center[0], arc.center[1]};
  const bool clockwise = arc.direction == Direction::clockwise;
  const double length = geometry::arc_length(from, to, centre, clockwise, arc.turns, 0);
  const double per_minute = post_rounded(motion::feed_per_minute(arc.feed, length, speed_rpm_));
  if (const auto rise = flat_rise(arc, *plane)) return flat_arc(arc, *plane, *rise);
  if (Posted(*this, arc, *plane).is_spiral()) return spiral(arc, *plane, per_minute);
  full_circles(arc, *plane, per_minute);
  rest_of_turn(arc, *plane, geometry::sweep_rad(from, to, centre, clockwise), per_minute);
}

// Less than a digit is enough to turn an arc that is next to nothing into a whole circle, or one
// that is nearly whole into nothing.
void Post::rest_of_turn(const Arc& arc, const PlaneAxes& plane, double sweep_rad,
                        double per_minute) {
  const double posted_rad = Posted(*this, arc, plane).sweep_rad();
  if (posted_rad > sweep_rad + std::numbers::pi) return line(arc.to, per_minute);
  if (posted_rad > sweep_rad - std::numbers::pi) return sweep(arc, plane, per_minute);
  Arc whole = arc;
  plane.place(whole.to, plane.project(at_));
  sweep(whole, plane, per_minute);
  line(arc.to, per_minute);
}

void Post::spiral(const Arc& arc, const PlaneAxes& plane, double per_minute) {
  const RoundWay way(plane, at_, arc);
  const double count = way.chord_count(kChordTolerance_mm);
  for (double n = 1; n <= count; ++n) line(way.at(n / count), per_minute);
}

// How high an arc rises above its chord, where its centre is too far away to be written.
std::optional<double> Post::flat_rise(const Arc& arc, const PlaneAxes& plane) const {
  const geometry::Vec2 from = plane.project(at_);
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
void Post::flat_arc(const Arc& arc, const PlaneAxes& plane, double rise) {
  if (rise < kChordTolerance_mm) return straight(arc.to, arc.feed);
  const geometry::Vec2 way = plane.project(arc.to) - plane.project(at_);
  const double side = (arc.direction == Direction::clockwise ? -rise : rise) / length(way);
  SpaceArc flat{.to = arc.to, .via = at_, .feed = arc.feed};
  for (std::size_t i = 0; i < axes_.count(); ++i)
    flat.via.values[i] += (arc.to.values[i] - at_.values[i]) / 2;
  flat.via[plane.first] += side * way.v;
  flat.via[plane.second] -= side * way.u;
  act(flat);
}

// Within half a digit of the output the arc lies in the plane, and nothing else moves.
std::optional<Arc> Post::plane_arc(const SpaceArc& arc, const geometry::SpaceArc& circle,
                                   Plane plane) const {
  const auto axes = plane_axes(plane, axes_);
  if (!axes || circle.radius() > kMostRadius_mm) return std::nullopt;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (axes->contains(base::Axis{static_cast<std::uint8_t>(i)})) continue;
    const double stays = post_rounded(at_.values[i]);
    const bool leaves = post_rounded(arc.via.values[i]) != stays ||
                        post_rounded(arc.to.values[i]) != stays ||
                        (arc.full_circle && post_rounded(arc.second_via.values[i]) != stays);
    if (leaves) return std::nullopt;
  }
  const geometry::Vec3& e3 = circle.e3();
  const geometry::Vec3& centre = circle.centre();
  const double upright = plane == Plane::xy ? e3.z : plane == Plane::zx ? e3.y : e3.x;
  const double tilt = std::sqrt(std::max(0.0, (1 - upright) * (1 + upright)));
  if (2 * circle.radius() * tilt > kHalfDigit_mm) return std::nullopt;
  const std::array<double, 2> in_plane = plane == Plane::xy   ? std::array{centre.x, centre.y}
                                         : plane == Plane::zx ? std::array{centre.z, centre.x}
                                                              : std::array{centre.y, centre.z};
  return Arc{.to = arc.to,
             .center = in_plane,
             .feed = arc.feed,
             .plane = plane,
             .direction = upright > 0 ? Direction::counterclockwise : Direction::clockwise};
}

void Post::act(const SpaceArc& arc) {
  const SpaceArcPath path(axes_, at_, arc);
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz}) {
    if (const auto flat = plane_arc(arc, path.circle(), plane)) return act(*flat);
  }
  const double most_rad = geometry::chord_angle_rad(path.circle().radius(), kChordTolerance_mm);
  const double per_minute =
      post_rounded(motion::feed_per_minute(arc.feed, path.circle().length(), speed_rpm_));
  path.chords(most_rad, [&](const base::TipPoint& to) { line(to, per_minute); });
}

}  // namespace kerf::output
