#pragma once

#include "kinematics/fault.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "motion/axis_norms.hpp"
#include "motion/curve.hpp"

namespace kerf::engraver {

/// The end of one step along a cut, and what may keep the wheel from the path on the way there, mm
/// (docs/pattern.md, "How near").
struct CutSample {
  double s = 0;              ///< parameter of the curve
  base::JointPoint joints;   ///< not rounded
  double half_pulse_mm = 0;  ///< both arms off by half a pulse, at the worse end of the step
  double joints_mm = 0;      ///< joints in proportion instead of the tip
  double chord_mm = 0;       ///< the curve between its ends
};

/// Cuts curves into steps that are as long as may be: no arm makes more than 30 pulses, the wheel's
/// path leaves the curve by no more than the tolerance leaves beside the pulses (and never has to
/// stay within less than kLeast_mm), and the tangent turns by at most half a tangent_jump_deg.
class CutSampler {
 public:
  static constexpr double kLeast_mm = 0.001;
  static constexpr double kShortest_mm = 1e-6;

  /// The machine must outlive the sampler.
  explicit CutSampler(const machine::PatternMachine& machine);

  /// The step from `s` < length, where the joints stand at `joints`. Faults: those of the linkage.
  [[nodiscard]] kinematics::Result<CutSample> next(const motion::Curve& curve, double s,
                                                   const base::JointPoint& joints);

 private:
  [[nodiscard]] kinematics::Result<CutSample> look(const motion::Curve& curve, double s, double end,
                                                   const base::JointPoint& joints) const;
  [[nodiscard]] double excess(const motion::Curve& curve, double s, const CutSample& sample,
                              const base::JointPoint& joints) const;
  [[nodiscard]] double curvature(const motion::Curve& curve, double s, double end) const;

  const machine::PatternMachine& machine_;
  motion::LinearAxes linear_;
  double most_turn_rad_;
  double step_mm_ = 0.1;  // that the last place took
};

}  // namespace kerf::engraver
