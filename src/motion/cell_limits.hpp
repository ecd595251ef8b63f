#pragma once

#include "motion/curve.hpp"
#include "motion/profile.hpp"
#include "motion/settings.hpp"

namespace kerf::motion {

/// What bounds the speed over a part of the path.
struct CellBounds {
  CurveBounds driven;    ///< derivatives of the driven axes by the parameter
  double curvature = 0;  ///< of the tip's path, 1/mm where the parameter is the length
  /// How far the tip leaves its line while the driven axes move in proportion: mm over the square
  /// of the step. 0 where they are the program's.
  double deviation = 0;
  /// Of the tip along the path beside it, mm/s²; 0: what driven axes have that are the program's.
  double tip_acceleration = 0;
  /// What is beside it may be quite different: within a chord of where its curve meets another, or
  /// where the linkage is what bends.
  bool at_border = false;
};

/// What a part of the path allows along it, from the derivatives q', q'', q''' of the driven axes:
///
///   |q' v| <= V,   |q' a + q'' v²| <= A,   |q' j + 3 q'' v a + q''' v³| <= J   for every axis.
///
/// The speed is limited first, so that path and corners leave a share of A and J for speeding up
/// and slowing down; acceleration and jerk are what remains of them at that speed.
///
/// Between two set-points the tip leaves a path of curvature κ by the deviation of the chord c = v
/// T, κ c²/8 and a little (motion/chord.hpp), and by that of the linkage, D c². The tolerance δ
/// holds both when c² <= 8 δ / (κ + 8 D). The chord has κ / (κ + 8 D) of it, and its exact formula.
/// What lies beside a bend may be driven faster, with acceleration a. Where a chord over both
/// begins to leave the path farther, speeds differ by some a T / 8, and it is by a share of g / 64
/// with g = a T² / c: so much less is c². Where g > 1 the borders of the bend are driven at 0.95 of
/// their speed, which is enough up to g = 2, and then so slowly that y = v T <= c/2 of them is
/// passed in a period, and y² + 2/27 a T² y <= c² where they are all of it.
class CellLimits {
 public:
  /// `axes` is the number of driven axes. `linear`: whether an axis of the program counts mm.
  CellLimits(const AxisLimits& axis_limits, const Settings& settings, std::size_t axes,
             const LinearAxes& linear);

  /// What a part of the path leaves for changes of speed.
  enum class Use : std::uint8_t {
    path,   ///< it is long: a good part of the limits is for them
    corner  ///< it is short, and driven at nearly constant speed
  };

  /// Limits for a part of the path with these bounds, for speeds up to `feed` > 0 (may be infinite;
  /// the result is not).
  [[nodiscard]] PathLimits of(const CellBounds& bounds, double feed, Use use) const;
  /// The highest speed at any feed; infinite where nothing limits it.
  [[nodiscard]] double highest_speed(const CellBounds& bounds, Use use) const;

  /// How much of an axis's acceleration or jerk the shape of the path takes at `speed`, at most.
  [[nodiscard]] double share_of_shape(const CellBounds& bounds, double speed) const;

  /// What the driven axes can give the tip along a path on which their derivatives are these; 0
  /// where none of them moves.
  [[nodiscard]] double acceleration_along(const base::AxisVector& first) const;

  /// How far from its ends a curve with these bounds has borders; 0: nowhere.
  [[nodiscard]] double border_mm(const CellBounds& bounds) const;

  [[nodiscard]] bool jerk_limited() const { return jerk_limited_; }
  [[nodiscard]] const AxisLimits& axis_limits() const { return limits_; }
  [[nodiscard]] double period_s() const { return period_s_; }
  [[nodiscard]] const LinearAxes& linear() const { return linear_; }

 private:
  [[nodiscard]] PathLimits without_jerk(const CurveBounds& bounds, double speed) const;
  [[nodiscard]] PathLimits with_jerk(const CurveBounds& bounds, double speed) const;
  [[nodiscard]] double acceleration_at(const CurveBounds& bounds, double speed) const;
  [[nodiscard]] double longest_chord(const CellBounds& bounds) const;
  [[nodiscard]] double most_speed_up(const CellBounds& bounds) const;
  [[nodiscard]] double tolerable_speed(const CellBounds& bounds) const;

  AxisLimits limits_;
  double chord_tolerance_mm_;
  double period_s_;
  double acceleration_;  // of the tip in any direction, where the driven axes are the program's
  std::size_t axes_ = 0;
  LinearAxes linear_{};
  bool jerk_limited_ = false;
};

}  // namespace kerf::motion
