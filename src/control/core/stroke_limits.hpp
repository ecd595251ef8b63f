#pragma once

#include <optional>

#include "base/point.hpp"
#include "control/core/surroundings.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// The stored stroke limits of axes that no linkage moves (parameter stroke_check).
class StrokeLimits {
 public:
  /// `on`: whether they are checked; `length`: of the tool, which counts, null for none. All must
  /// outlive this.
  StrokeLimits(const motion::AxisSetup& axes, const bool& on, const base::AxisVector* length)
      : axes_(axes), on_(on), length_(length) {}

  /// Whether the axis can stand there, machine coordinates, without the tool's length; else the
  /// alarm with its values.
  [[nodiscard]] std::optional<Refusal> refusal(base::Axis axis, double target) const;
  /// The same of every place of a move that begins at `from`, bulges of arcs too: the first axis
  /// that would go beyond a limit. An axis that is beyond one may stay there or come back.
  [[nodiscard]] std::optional<Refusal> refusal(const base::TipPoint& from,
                                               const motion::Motion& move) const;

 private:
  const motion::AxisSetup& axes_;
  const bool& on_;
  const base::AxisVector* length_;
};

}  // namespace kerf::control
