#pragma once

#include "base/axes.hpp"
#include "base/path_jet.hpp"
#include "base/point.hpp"

// What all linkages speak of.
namespace kerf::kinematics {

using base::Axis;
using base::AxisVector;
using base::JointJet;
using base::JointPoint;
using base::TipJet;
using base::TipPoint;

/// Where the linkages have them: of the tip, and of joints that are called so.
inline constexpr Axis kX{0};
inline constexpr Axis kY{1};
inline constexpr Axis kZ{2};

}  // namespace kerf::kinematics
