#pragma once

#include "motion/curve.hpp"
#include "planner/profile.hpp"
#include "planner/settings.hpp"

namespace kerf::planner {

/// How a linkage leads the tip from its path between two set-points, by the derivatives of the
/// driven axes. All 0 where these are the program's.
struct LinkageBend {
  double bend = 0;   ///< of the tip, were the axes to change by their second derivatives: mm
  double swing = 0;  ///< Linkage::swing_mm() of their first derivatives: mm
  double gain = 0;   ///< the same of their accelerations: mm/s⁴
};

/// What bounds the speed over a part of the path.
struct CellBounds {
  motion::CurveBounds driven;  ///< derivatives of the driven axes by the parameter
  double curvature = 0;        ///< of the tip's path, 1/mm where the parameter is the length
  LinkageBend linkage = {};
  /// Of the tip along the path beside it, mm/s²; 0: what driven axes have that are the program's.
  double tip_acceleration = 0;
  /// What is beside it may be quite different: within a chord of where its curve meets another.
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
/// T, κ c²/8 and a little (motion/chord.hpp), which is the tolerance δ at most. Through a linkage
/// it leaves it by what the driven axes leave their own ways, J q'' c²/8 with the derivative J of
/// the tip by the axes, and by what J and q' change in a period (docs/motion.md, "Through a
/// linkage"):
///
///   E c² + c √(N G) T²/6 + 11/48 G T⁴ <= 8 δ
///
/// E is the larger of κ and |J q''|, N and G are the swings of q' and of the accelerations. This
/// holds whatever lies beside. Where the last term has more than kMostOfGain of δ the axes can turn
/// to anything within a period: there chord and swing count together, c² <= 8 δ / (κ + N), and
/// everything is a border.
///
/// What lies beside a bend may be driven faster, with acceleration a. Where a chord over both
/// begins to leave the path farther, speeds differ by some a T / 8, and it is by a share of g / 64
/// with g = a T² / c: so much less is c². Where g > 1 the borders of the bend are driven at 0.95 of
/// their speed, which is enough up to g = 2, and then so slowly that y = v T <= c/2 of them is
/// passed in a period, and y² + 2/27 a T² y <= c² where they are all of it.
class CellLimits {
 public:
  /// `axes` is the number of driven axes. `linear`: whether an axis of the program counts mm.
  CellLimits(const AxisLimits& axis_limits, const Settings& settings, std::size_t axes,
             const motion::LinearAxes& linear);

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
  /// Number of driven axes.
  [[nodiscard]] std::size_t axes() const { return axes_; }
  [[nodiscard]] double period_s() const { return period_s_; }
  [[nodiscard]] const motion::LinearAxes& linear() const { return linear_; }

 private:
  [[nodiscard]] PathLimits without_jerk(const motion::CurveBounds& bounds, double speed) const;
  [[nodiscard]] PathLimits with_jerk(const motion::CurveBounds& bounds, double speed) const;
  [[nodiscard]] bool allows(const CellBounds& bounds, double speed, Use use) const;
  [[nodiscard]] double longest_chord(const CellBounds& bounds) const;
  [[nodiscard]] bool is_chord_longer(const CellBounds& bounds, double chord) const;
  [[nodiscard]] double longest_linkage_chord(const CellBounds& bounds) const;
  [[nodiscard]] bool turns_to_anything(const LinkageBend& linkage) const;
  [[nodiscard]] double most_speed_up(const CellBounds& bounds) const;
  [[nodiscard]] double tolerable_speed(const CellBounds& bounds) const;

  AxisLimits limits_;
  double chord_tolerance_mm_;
  double period_s_;
  double acceleration_;  // of the tip in any direction, where the driven axes are the program's
  std::size_t axes_ = 0;
  motion::LinearAxes linear_{};
  bool jerk_limited_ = false;
};

}  // namespace kerf::planner
