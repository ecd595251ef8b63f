#pragma once

#include <array>
#include <optional>

#include "base/axes.hpp"
#include "motion/axis_setup.hpp"
#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// Where the picture shows a tip position of a machine: its X, Y and Z as lengths, 0 for an axis
/// that the machine lacks or that turns. Value type.
class TipInSpace {
 public:
  explicit TipInSpace(const motion::AxisSetup& axes);

  /// A coordinate that is not finite is that of `otherwise`; one beyond what can be drawn is there.
  [[nodiscard]] Point3 point_of(const base::TipPoint& tip, const Point3& otherwise) const;
  /// X, Y or Z.
  [[nodiscard]] bool has(std::size_t coordinate) const { return from_[coordinate].has_value(); }

 private:
  std::array<std::optional<base::Axis>, 3> from_{};
};

}  // namespace kerf::output::plot
