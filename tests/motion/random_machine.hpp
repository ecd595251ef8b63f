#pragma once

#include <memory>
#include <optional>

#include "base/axes.hpp"
#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"
#include "seeded_random.hpp"

namespace kerf::test {

/// A linkage of random size, and the part of its workspace in which random paths lie.
struct RandomMachine {
  std::shared_ptr<const kinematics::Kinematics> kinematics;
  base::TipPoint start;  ///< of the tip
  base::JointPoint joints;
  double least_radius_mm = 0;  ///< of the tip from the axis of the work, or the shoulder
  double most_radius_mm = 0;

  [[nodiscard]] bool allows(const base::TipPoint& tip) const;
};

/// `kind` is not Cartesian. Arms and works keep off their singular places: by 3 to 30 degrees of
/// the elbow, and by 0.5 to 20 mm.
[[nodiscard]] RandomMachine random_machine(kinematics::Kind kind, SeededRandom& random);

}  // namespace kerf::test
