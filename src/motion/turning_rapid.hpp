#pragma once

#include <optional>

#include "base/point.hpp"
#include "motion/axis_setup.hpp"
#include "motion/curve.hpp"

namespace kerf::motion {

/// The way of a rapid from point to point on a machine whose work turns about X0 Y0 under the tip
/// (AxisSetup::turning_work): the radius r, the angle φ and all other axes change in proportion, so
/// the driven axes start and stop together. On the work the tip draws a part of a spiral:
///
///     r(s) = r0 + (r1 - r0) s / L,    φ(s) = φ0 + Δφ s / L,    Δφ in [-180, 180) degrees
///
/// Where one of the ends is on the axis, within kOnAxis_mm, no angle is determined there; that way,
/// as any with Δφ = 0, is straight.
class TurningRapid {
 public:
  static constexpr double kOnAxis_mm = 1e-9;

  /// Nothing: the way is straight. Precondition: the machine has turning_work.
  [[nodiscard]] static std::optional<TurningRapid> between(const AxisSetup& axes,
                                                           const base::TipPoint& from,
                                                           const base::TipPoint& to);
  /// How long a rapid takes without acceleration, the slowest of the driven axes, s; also a
  /// straight one. Precondition: as above.
  [[nodiscard]] static double seconds(const AxisSetup& axes, const base::TipPoint& from,
                                      const base::TipPoint& to);

  /// Its parameter is roughly the length in X and Y.
  [[nodiscard]] Curve curve() const;
  /// In X, Y and Z, mm, to 1e-9 of it.
  [[nodiscard]] double length_mm() const;

 private:
  TurningRapid() = default;

  const AxisSetup* axes_ = nullptr;
  base::TipPoint from_;
  base::TipPoint to_;
  double begin_radius_mm_ = 0;
  double radius_change_mm_ = 0;
  double begin_rad_ = 0;
  double turn_rad_ = 0;  // not 0
};

}  // namespace kerf::motion
