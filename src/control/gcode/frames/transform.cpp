#include "control/gcode/frames/transform.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisVector;
using geometry::sine_cosine_deg;
using geometry::SineCosine;
using geometry::Vec2;

Vec2 turned(Vec2 point, Vec2 centre, const SineCosine& angle) {
  const Vec2 arm = point - centre;
  return centre +
         Vec2{arm.u * angle.cosine - arm.v * angle.sine, arm.u * angle.sine + arm.v * angle.cosine};
}

}  // namespace

void Transform::scale(const AxisVector& centre, const AxisVector& factors) {
  scaled_ = true;
  scale_centre_ = centre;
  factors_ = factors;
}

void Transform::cancel_scaling() { scaled_ = false; }

void Transform::mirror(Axis axis, double at) {
  mirrored_ = static_cast<base::AxisSet>(mirrored_ | base::only(axis));
  mirror_at_[axis] = at;
}

void Transform::cancel_mirror(Axis axis) {
  mirrored_ = static_cast<base::AxisSet>(mirrored_ & ~base::only(axis));
}

void Transform::rotate(const motion::PlaneAxes& plane, Vec2 centre, double angle_deg) {
  rotated_ = true;
  rotation_plane_ = plane;
  rotation_centre_ = centre;
  angle_deg_ = angle_deg;
}

void Transform::cancel_rotation() { rotated_ = false; }

AxisVector Transform::mirrored_and_scaled(AxisVector point) const {
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (base::contains(mirrored_, axis)) point[axis] = 2 * mirror_at_[axis] - point[axis];
    if (scaled_)
      point[axis] = scale_centre_[axis] + factors_[axis] * (point[axis] - scale_centre_[axis]);
  }
  return point;
}

double Transform::effective_angle_deg() const {
  const bool first = base::contains(mirrored_, rotation_plane_.first);
  const bool second = base::contains(mirrored_, rotation_plane_.second);
  return first != second ? -angle_deg_ : angle_deg_;
}

AxisVector Transform::apply(const AxisVector& point) const {
  AxisVector result = mirrored_and_scaled(point);
  if (!rotated_) return result;
  AxisVector centre = point;
  rotation_plane_.place(centre, rotation_centre_);
  const Vec2 pivot = rotation_plane_.project(mirrored_and_scaled(centre));
  rotation_plane_.place(result, turned(rotation_plane_.project(result), pivot,
                                       sine_cosine_deg(effective_angle_deg())));
  return result;
}

AxisVector Transform::invert(const AxisVector& point) const {
  AxisVector result = point;
  if (rotated_) {
    AxisVector centre = point;
    rotation_plane_.place(centre, rotation_centre_);
    const Vec2 pivot = rotation_plane_.project(mirrored_and_scaled(centre));
    rotation_plane_.place(result, turned(rotation_plane_.project(result), pivot,
                                         sine_cosine_deg(-effective_angle_deg())));
  }
  for (std::size_t i = 0; i < base::kMaxAxes; ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (scaled_ && factors_[axis] != 0) {
      result[axis] = scale_centre_[axis] + (result[axis] - scale_centre_[axis]) / factors_[axis];
    }
    if (base::contains(mirrored_, axis)) result[axis] = 2 * mirror_at_[axis] - result[axis];
  }
  return result;
}

bool Transform::reverses(const motion::PlaneAxes& plane) const {
  bool result = base::contains(mirrored_, plane.first) != base::contains(mirrored_, plane.second);
  if (scaled_ && factors_[plane.first] * factors_[plane.second] < 0) result = !result;
  return result;
}

double Transform::factor(Axis axis) const { return scaled_ ? std::fabs(factors_[axis]) : 1; }

bool Transform::scales_evenly(const motion::PlaneAxes& plane) const {
  return factor(plane.first) == factor(plane.second);
}

double Transform::radius_factor(const motion::PlaneAxes& plane) const {
  return std::fmax(factor(plane.first), factor(plane.second));
}

}  // namespace kerf::control
