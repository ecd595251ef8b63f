#pragma once

#include "base/axes.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::control {

/// Scaling (G51), mirror image (G51.1) and rotation (G68) of programmed points, in this order:
///   q = mirror(p);  s = c + k (q - c) per axis;  r = d + Rot(angle)(s - d),  d the image of the
///   centre
/// of rotation under the first two. One mirrored axis of the plane turns the sense of the rotation
/// (docs/dialect.md §8.5). Value type; the identity when made.
class Transform {
 public:
  void scale(const base::AxisVector& centre, const base::AxisVector& factors);
  void cancel_scaling();
  void mirror(base::Axis axis, double at);
  void cancel_mirror(base::Axis axis);
  void rotate(const motion::PlaneAxes& plane, geometry::Vec2 centre, double angle_deg);
  void cancel_rotation();

  [[nodiscard]] bool identity() const { return !scaled_ && mirrored_ == 0 && !rotated_; }
  [[nodiscard]] bool scaled() const { return scaled_; }
  [[nodiscard]] bool rotated() const { return rotated_; }
  /// True when this is the plane of the rotation.
  [[nodiscard]] bool rotates(const motion::PlaneAxes& plane) const {
    return rotated_ && plane.first == rotation_plane_.first &&
           plane.second == rotation_plane_.second;
  }
  [[nodiscard]] double rotation_deg() const { return angle_deg_; }
  [[nodiscard]] base::AxisSet mirrored() const { return mirrored_; }

  [[nodiscard]] base::AxisVector apply(const base::AxisVector& point) const;
  [[nodiscard]] base::AxisVector invert(const base::AxisVector& point) const;

  /// True when the image of a counterclockwise arc in `plane` runs clockwise.
  [[nodiscard]] bool reverses(const motion::PlaneAxes& plane) const;
  /// Both axes of `plane` have a factor of the same size.
  [[nodiscard]] bool scales_evenly(const motion::PlaneAxes& plane) const;
  /// Size of the factor of an axis.
  [[nodiscard]] double factor(base::Axis axis) const;
  /// Factor by which a radius in `plane` grows: the larger one when the two differ.
  [[nodiscard]] double radius_factor(const motion::PlaneAxes& plane) const;

 private:
  [[nodiscard]] base::AxisVector mirrored_and_scaled(base::AxisVector point) const;
  [[nodiscard]] double effective_angle_deg() const;

  bool scaled_ = false;
  base::AxisVector scale_centre_;
  base::AxisVector factors_;
  base::AxisSet mirrored_ = 0;
  base::AxisVector mirror_at_;
  bool rotated_ = false;
  motion::PlaneAxes rotation_plane_;
  geometry::Vec2 rotation_centre_;
  double angle_deg_ = 0;
};

}  // namespace kerf::control
