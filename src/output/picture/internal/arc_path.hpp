#pragma once

#include <cstddef>

#include "motion/motion.hpp"
#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// Cubic Bezier curve from where the pen stands.
struct Bezier {
  Point3 control1;
  Point3 control2;
  Point3 to;
};

/// Arc, spiral or helix about an axis parallel to X, Y or Z:
/// p(t) = center + r(t) (cos a(t), sin a(t)) in the plane, with angle, radius and the height over
/// the plane linear in t, 0 <= t <= 1. Value type.
class ArcPath {
 public:
  /// As control::Arc defines it. Of more than kMaxTurns extra turns only so many are drawn, over
  /// the whole height.
  ArcPath(const Point3& from, const motion::Arc& arc, const Point3& to,
          const std::array<double, 2>& center);

  static constexpr int kMaxTurns = 100;

  [[nodiscard]] Point3 at(double t) const;
  [[nodiscard]] const Point3& from() const { return from_; }
  [[nodiscard]] const Point3& to() const { return to_; }

  /// Adds the arc's extents to `box`; exact when the radius is constant.
  void extend(Box3& box) const;

  /// Bezier curves, each at most a quarter turn, that follow the arc to 0.03 % of its radius.
  [[nodiscard]] std::size_t span_count() const;
  [[nodiscard]] Bezier span(std::size_t number) const;

  /// How many equal chords stay within `tolerance` > 0 of the arc; at least six and at most 3600
  /// a turn.
  [[nodiscard]] std::size_t chord_count(double tolerance) const;

 private:
  [[nodiscard]] Point3 derivative(double t) const;

  Point3 from_, to_;
  std::array<double, 2> center_;
  std::size_t first_, second_, normal_;  // which coordinates span the plane
  double angle_rad_ = 0;                 // at the start
  double sweep_rad_ = 0;                 // signed
  double radius_ = 0;                    // at the start
  double radius_growth_ = 0;
};

}  // namespace kerf::output::plot
