#pragma once

#include <cstdint>
#include <tl/expected.hpp>

#include "geometry/vec3.hpp"

namespace kerf::geometry {

/// Why three points, in the order of travel, carry no arc.
enum class NoArc : std::uint8_t {
  straight,   ///< the second lies between the others: the way is two lines
  collinear,  ///< on one line, and the second does not lie between the others
  coincident  ///< two of them are one (kSamePoint_mm)
};

/// The way along a circle in space from P1 through P2 to P3, or on from there back to P1:
///
///             P2             p(θ) = O + R (cos θ e1 + sin θ e2),  0 <= θ <= sweep
///         .   |   .
///       .     | e2  .        O   centre, R radius
///      P3     O --- P1       e1  from O to P1
///                e1          e3 = e1 × e2, unit normal of the plane
///
/// e3 points to where the way is seen to run counter-clockwise, whatever its sweep: P2 and P3 lie
/// at the angles 0 < to_second < to_third < 2π. e1, e2, e3 are orthonormal to 1e-12. Value type.
class SpaceArc {
 public:
  /// Ends at P3.
  [[nodiscard]] static tl::expected<SpaceArc, NoArc> through(Vec3 p1, Vec3 p2, Vec3 p3);
  /// Goes once round, through P2 and P3, and ends at P1. Points on one line are `collinear`.
  [[nodiscard]] static tl::expected<SpaceArc, NoArc> circle(Vec3 p1, Vec3 p2, Vec3 p3);

  [[nodiscard]] Vec3 centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] Vec3 e1() const { return e1_; }
  [[nodiscard]] Vec3 e2() const { return e2_; }
  [[nodiscard]] Vec3 e3() const { return e3_; }

  [[nodiscard]] double to_second_rad() const { return to_second_rad_; }
  [[nodiscard]] double to_third_rad() const { return to_third_rad_; }
  [[nodiscard]] double sweep_rad() const { return sweep_rad_; }
  [[nodiscard]] double length() const { return radius_ * sweep_rad_; }

  /// p(angle), the angle clamped to [0, sweep]. Both ends are exactly the points given. Flat arcs
  /// of a huge radius lose no digits.
  [[nodiscard]] Vec3 at(double angle_rad) const;
  /// Direction of travel at an angle, unit length.
  [[nodiscard]] Vec3 tangent(double angle_rad) const;
  /// The angle, in [0, 2π), of the point of the whole circle that lies farthest in `direction`.
  [[nodiscard]] double farthest_rad(Vec3 direction) const;

 private:
  SpaceArc(Vec3 p1, Vec3 p2, Vec3 p3);

  Vec3 begin_, end_;
  Vec3 centre_;
  double radius_ = 0;
  Vec3 e1_, e2_, e3_;
  double to_second_rad_ = 0;
  double to_third_rad_ = 0;
  double sweep_rad_ = 0;
};

}  // namespace kerf::geometry
