#pragma once

#include <memory>
#include <optional>

#include "base/diagnostic.hpp"
#include "control/core/surroundings.hpp"
#include "kinematics/kinematics.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

class Reach;

/// The joints of a linkage along the moves of a run: which one they cannot follow, and the first
/// cut that comes near to a singular position. Where the driven axes are the program's own there is
/// nothing to watch.
class JointWatch {
 public:
  using Intent = control::Surroundings::Intent;

  /// Both must outlive this. `start`: where the joints stand.
  JointWatch(const kinematics::Kinematics& kinematics, const motion::AxisSetup& axes,
             const base::JointPoint& start);
  ~JointWatch();

  /// As control::Surroundings::refusal() has it.
  [[nodiscard]] std::optional<control::Refusal> refusal(const base::TipPoint& from,
                                                        const motion::Motion& move, Intent intent);
  /// Where the axes stand now, behind moves that were not made.
  void stand_at(const base::JointPoint& joints);
  /// The warning of the first cut near a singular position, since forget_caution().
  [[nodiscard]] const std::optional<base::Diagnostic>& caution() const { return caution_; }
  void forget_caution() { caution_.reset(); }

 private:
  void look_for_caution(const motion::Motion& move);

  const motion::AxisSetup& axes_;
  std::unique_ptr<Reach> reach_;  // null: nothing to watch
  std::optional<base::Diagnostic> caution_;
};

}  // namespace kerf::machine
