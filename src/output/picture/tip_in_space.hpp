#pragma once

#include <array>

#include "base/axes.hpp"
#include "motion/axis_setup.hpp"
#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// Where the picture shows a tip position of a machine: its X, Y and Z as lengths, 0 for an axis
/// that the machine lacks or that turns. Value type.
class TipInSpace {
 public:
  /// `x_scale`: lengths along X are the X words times this.
  TipInSpace(const motion::AxisSetup& axes, double x_scale);

  /// A coordinate that is not finite is that of `otherwise`; one beyond what can be drawn is there.
  [[nodiscard]] Point3 point_of(const base::TipPoint& tip, const Point3& otherwise) const;
  /// Of X, Y or Z: its lengths are words times this; 0 when the machine lacks it.
  [[nodiscard]] double scale(std::size_t coordinate) const { return from_[coordinate].scale; }

 private:
  struct Coordinate {
    std::size_t axis = 0;
    double scale = 0;
  };
  std::array<Coordinate, 3> from_{};
};

}  // namespace kerf::output::plot
