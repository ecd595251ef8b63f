#include "motion/surface_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angle.hpp"
#include "geometry/arc.hpp"
#include "math/math.hpp"

namespace kerf::motion {
namespace {

using base::Axis;
using base::TipPoint;
using geometry::Vec2;

// Of how far a curve on a face is away from the centre where it begins.
constexpr double kOfDistance = 0.5;
constexpr double kWithSliver = 1.25;
// Of one curve of an arc, so that each axis turns round once on it at most.
constexpr double kMostSweep_rad = std::numbers::pi / 3;
// Turns by less are rounding, degrees.
constexpr double kNoTurn = 1e-9;

double mm_per_degree(const Surface& surface) { return geometry::radians(surface.radius_mm); }

}  // namespace

Vec2 flat_of(const Surface& surface, const TipPoint& tip) {
  if (surface.kind == Surface::Kind::cylinder)
    return {tip[surface.first], tip[surface.rotary] * mm_per_degree(surface)};
  const double x = tip[surface.first] - surface.centre_mm;
  const auto turn = geometry::sine_cosine_deg(tip[surface.rotary] - surface.zero_deg);
  return {x * turn.cosine, x * turn.sine};
}

TipPoint end_of(const AxisSetup& axes, const TipPoint& from, const SurfaceMove& move) {
  return SurfacePath(axes, from, move, [](const Curve&) {}).end();
}

Vec2 SurfacePath::Arc::at(double s) const {
  const math::SineCosine turned = math::sine_cosine(angle_rad + rate * s);
  return centre + (radius + radius_slope * s) * Vec2{turned.cosine, turned.sine};
}

// The part of it behind `begin`; the second axis of the plane counts `per_mm` for each mm.
Curve SurfacePath::Arc::curve(const Surface& surface, double per_mm, double begin,
                              const TipPoint& from, const TipPoint& to, double length,
                              std::size_t axes) const {
  ArcShape shape;
  shape.origin = from;
  for (std::size_t m = 0; m < axes; ++m)
    shape.slope.values[m] = (to.values[m] - from.values[m]) / length;
  shape.origin[surface.first] = centre.u;
  shape.origin[surface.rotary] = centre.v * per_mm;
  shape.slope[surface.first] = shape.slope[surface.rotary] = 0;
  shape.e1[surface.first] = 1;
  shape.e2[surface.rotary] = per_mm;
  shape.radius = radius + radius_slope * begin;
  shape.radius_slope = radius_slope;
  shape.angle_rad = angle_rad + rate * begin;
  shape.rate = rate;
  return Curve::arc(shape, to, length, axes);
}

SurfacePath::SurfacePath(const AxisSetup& axes, const TipPoint& from, const SurfaceMove& move,
                         Visit visit)
    : axes_(axes),
      surface_(move.surface),
      visit_(std::move(visit)),
      is_arc_(move.is_arc),
      from_(flat_of(move.surface, from)),
      to_{move.flat_to[0], move.flat_to[1]},
      start_(from),
      target_(move.to),
      at_(from) {
  if (is_arc_) {
    measure_arc({move.about[0], move.about[1]}, move.direction == Direction::clockwise);
  } else {
    length_ = length_of_line();
  }
  if (length_ > 0) add_curves();
}

void SurfacePath::add_curves() {
  if (surface_.kind == Surface::Kind::cylinder) return add_rolled();
  if (is_arc_) return add_arc();
  add_line();
}

double SurfacePath::length_of_line() const {
  double square = dot(to_ - from_, to_ - from_);
  for (std::size_t m = 0; m < axes_.count(); ++m) {
    if (axes_.axes[m].rotary || Axis{static_cast<std::uint8_t>(m)} == surface_.first) continue;
    const double way = target_.values[m] - start_.values[m];
    square += way * way;
  }
  return std::sqrt(square);
}

void SurfacePath::measure_arc(Vec2 centre, bool clockwise) {
  const double sweep = geometry::sweep_rad(from_, to_, centre, clockwise);
  const double last = geometry::length(to_ - centre);
  arc_.centre = centre;
  arc_.radius = geometry::length(from_ - centre);
  length_ = sweep * (arc_.radius + last) / 2;
  if (length_ == 0) return;
  arc_.radius_slope = (last - arc_.radius) / length_;
  arc_.angle_rad = math::atan2(from_.v - centre.v, from_.u - centre.u);
  arc_.rate = (clockwise ? -sweep : sweep) / length_;
}

Vec2 SurfacePath::at(double s) const {
  if (s <= 0) return from_;
  if (s >= length_) return to_;
  return is_arc_ ? arc_.at(s) : from_ + (s / length_) * (to_ - from_);
}

// Of a face: the two axes count mm in the plane.
TipPoint SurfacePath::flat_point(double s) const {
  TipPoint point;
  for (std::size_t m = 0; m < axes_.count(); ++m)
    point.values[m] =
        start_.values[m] + (target_.values[m] - start_.values[m]) * std::min(1.0, s / length_);
  const Vec2 flat = at(s);
  point[surface_.first] = flat.u;
  point[surface_.rotary] = flat.v;
  return point;
}

double SurfacePath::angle_near(Vec2 flat, double near_deg) const {
  const Vec2 out = surface_.side * flat;
  const double angle = surface_.zero_deg + geometry::degrees(math::atan2(out.v, out.u));
  return geometry::nearest_turn(angle, near_deg);
}

TipPoint SurfacePath::on_machine(double s) const {
  TipPoint point = flat_point(s);
  const Vec2 flat{point[surface_.first], point[surface_.rotary]};
  const double distance = geometry::length(flat);
  point[surface_.first] = surface_.centre_mm + surface_.side * distance;
  point[surface_.rotary] =
      distance < kThrough ? at_[surface_.rotary] : angle_near(flat, at_[surface_.rotary]);
  return point;
}

// The mantle rolls without slipping: a straight plane whose second axis counts degrees.
void SurfacePath::add_rolled() {
  const double parts =
      is_arc_ ? std::ceil(std::fabs(arc_.rate) * length_ / kMostSweep_rad - kNoTurn) : 1;
  const double per_mm = 1 / mm_per_degree(surface_);
  double begin = 0;
  for (double n = 1; n <= parts; ++n) {
    const double end = n == parts ? length_ : length_ * n / parts;
    TipPoint to = flat_point(end);
    to[surface_.rotary] *= per_mm;
    visit_(is_arc_ ? arc_.curve(surface_, per_mm, begin, at_, to, end - begin, axes_.count())
                   : Curve::line(at_, to, length_, axes_.count()));
    at_ = to;
    begin = end;
  }
}

void SurfacePath::add_line() {
  const Vec2 way = to_ - from_;
  const double square = dot(way, way);
  const double foot = square > 0 ? std::clamp(-dot(from_, way) / square, 0.0, 1.0) : 0;
  if (geometry::length(from_ + foot * way) >= kThrough) return add_line_between(0, length_);
  go_through(0, foot * length_, length_);
}

// Where it is nearest to the centre if it comes there.
double SurfacePath::nearest_of_arc() const {
  const double turn = 2 * std::numbers::pi;
  const double away = math::atan2(-arc_.centre.v, -arc_.centre.u);
  double angle = std::fmod((away - arc_.angle_rad) * (arc_.rate < 0 ? -1 : 1), turn);
  if (angle < 0) angle += turn;
  return std::min(length_, angle / std::fabs(arc_.rate));
}

void SurfacePath::add_arc() {
  const double off = geometry::length(arc_.centre);
  if (off == 0) return add_arc_between(0, length_);
  const double ratio = std::min(1.0, kStraight / (2 * std::sqrt(off * arc_.radius)));
  const double reach = std::min(length_ / 2, 2 * math::asin(ratio) / std::fabs(arc_.rate));
  const bool begins_there = geometry::length(from_) < kThrough;
  const bool ends_there = geometry::length(to_) < kThrough;
  const double nearest = nearest_of_arc();
  double begin = 0;
  if (begins_there) {
    begin = reach;
    go_through(0, 0, begin);
  } else if (!ends_there && geometry::length(at(nearest)) < kThrough) {
    begin = std::min(length_, nearest + reach);
    const double enter = std::max(0.0, nearest - reach);
    add_arc_between(0, enter);
    go_through(enter, nearest, begin);
  }
  const double end = ends_there ? length_ - reach : length_;
  add_arc_between(begin, end);
  if (ends_there) go_through(end, length_, length_);
}

// In from one place, and out to another one.
void SurfacePath::go_through(double enter, double centre, double leave) {
  add_radial(enter, centre);
  if (leave > centre && geometry::length(at(leave)) >= kThrough) turn_to(at(leave));
  add_radial(centre, leave);
}

// Straight between a place and the centre, whichever is first; the rotary axis stands.
void SurfacePath::add_radial(double begin, double end) {
  if (!(end > begin)) return;
  const double out = geometry::length(at(end));
  const bool is_centre = out < kThrough;
  TipPoint to = flat_point(end);
  to[surface_.first] = surface_.centre_mm + (is_centre ? 0 : surface_.side * out);
  to[surface_.rotary] =
      is_centre ? at_[surface_.rotary] : angle_near(at(end), at_[surface_.rotary]);
  visit_(Curve::line(at_, to, end - begin, axes_.count()));
  at_ = to;
}

void SurfacePath::turn_to(Vec2 flat) {
  TipPoint to = at_;
  double way = angle_near(flat, at_[surface_.rotary]) - at_[surface_.rotary];
  if (std::fabs(way) < kNoTurn) return;
  if (way < -180 + kNoTurn) way += 360;  // of two half turns the positive one
  to[surface_.rotary] += way;
  visit_(Curve::line(at_, to, std::fabs(way), axes_.count()));
  at_ = to;
}

// Where the curve ends that begins at a place, on the way to `end`: no sliver is left.
double SurfacePath::next_end(double begin, double end) const {
  const double share = is_arc_ ? 1 : geometry::length(to_ - from_) / length_;
  double most = kOfDistance * geometry::length(at(begin));
  if (is_arc_) most = std::min(most, kMostSweep_rad / std::fabs(arc_.rate));
  return share * (end - begin) <= kWithSliver * most ? end : begin + most / share;
}

void SurfacePath::add_line_between(double begin, double end) {
  while (begin < end) {
    const double next = next_end(begin, end);
    put_on_face(Curve::line(flat_point(begin), flat_point(next), next - begin, axes_.count()),
                next);
    begin = next;
  }
}

void SurfacePath::add_arc_between(double begin, double end) {
  while (begin < end) {
    const double next = next_end(begin, end);
    put_on_face(arc_.curve(surface_, 1, begin, flat_point(begin), flat_point(next), next - begin,
                           axes_.count()),
                next);
    begin = next;
  }
}

void SurfacePath::put_on_face(const Curve& flat, double end) {
  const TipPoint begin = flat.at(0);
  FaceMap map{surface_.first, surface_.rotary, surface_.centre_mm, surface_.side, {}, 0};
  map.begin = map.flat(begin);
  map.begin_deg = at_[surface_.rotary];
  at_ = on_machine(end);
  visit_(Curve::on_face(flat, map, at_));
}

}  // namespace kerf::motion
