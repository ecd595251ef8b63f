#pragma once

#include "motion/curve.hpp"
#include "motion/profile.hpp"
#include "motion/settings.hpp"

namespace kerf::motion {

/// What a part of the path allows along it, from the derivatives q', q'', q''' of the driven axes:
///
///   |q' v| <= V,   |q' a + q'' v²| <= A,   |q' j + 3 q'' v a + q''' v³| <= J   for every axis.
///
/// The speed is limited first, so that path and corners leave a share of A and J for speeding up
/// and slowing down; acceleration and jerk are what remains of them at that speed.
class CellLimits {
 public:
  /// `linear`: whether an axis counts mm. The first `axes` entries are used.
  CellLimits(const AxisLimits& axis_limits, const Settings& settings, std::size_t axes,
             std::array<bool, base::kMaxAxes> linear);

  /// What a part of the path leaves for changes of speed.
  enum class Use : std::uint8_t {
    path,   ///< it is long: a good part of the limits is for them
    corner  ///< it is short, and driven at nearly constant speed
  };

  /// Limits for a part of the path with these bounds, for speeds up to `feed` > 0 (may be infinite;
  /// the result is not).
  [[nodiscard]] PathLimits of(const CurveBounds& bounds, double feed, Use use) const;

  [[nodiscard]] bool jerk_limited() const { return jerk_limited_; }
  [[nodiscard]] const AxisLimits& axis_limits() const { return limits_; }

 private:
  [[nodiscard]] PathLimits without_jerk(const CurveBounds& bounds, double speed) const;
  [[nodiscard]] PathLimits with_jerk(const CurveBounds& bounds, double speed, Use use) const;
  [[nodiscard]] double acceleration_at(const CurveBounds& bounds, double speed) const;
  [[nodiscard]] double highest_speed(const CurveBounds& bounds, Use use) const;

  AxisLimits limits_;
  double chord_speed_ = 0;  // v √κ for the chord tolerance
  std::size_t axes_ = 0;
  std::array<bool, base::kMaxAxes> linear_{};
  bool jerk_limited_ = false;
};

}  // namespace kerf::motion
