#pragma once

#include "base/axes.hpp"

namespace kerf::kinematics {

/// Where the linkages have them: of the tip, and of joints that are called so.
inline constexpr base::Axis kX{0};
inline constexpr base::Axis kY{1};
inline constexpr base::Axis kZ{2};

}  // namespace kerf::kinematics
