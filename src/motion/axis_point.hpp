#pragma once

#include "base/axes.hpp"
#include "base/interface.hpp"
#include "motion/setpoint.hpp"

namespace kerf::motion {

/// A set-point with where the driven axes stand then, in the order of the machine file.
struct AxisPoint {
  Setpoint tip;
  base::JointPoint joints;
  /// Of the laser in the period that ends here, percent of full: where it follows the speed, that
  /// of the tip in the period, to 0.01 (docs/drives.md, Power that follows the speed).
  float power_percent = 0;
};

/// Receives the set-points of a run in the order of their times: one for every period of the servo,
/// if the machine's Sampling has one.
class AxisPointSink : public base::Interface {
 public:
  /// Where the axes stand before the first point, and anew when they go on after breaking off.
  virtual void start(const AxisPoint& /*at*/) {}
  virtual void take(const AxisPoint& point) = 0;
};

}  // namespace kerf::motion
