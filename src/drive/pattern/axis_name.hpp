#pragma once

#include <array>
#include <string_view>

#include "drive/arm_axis.hpp"

namespace kerf::drive {

/// Names of the motors in listings, whatever the machine file calls its axes.
inline constexpr std::array<std::string_view, kArmAxes> kArmAxisNames = {"T1", "T2", "T3", "Z"};

constexpr std::string_view axis_name(ArmAxis axis) { return kArmAxisNames[index(axis_of(axis))]; }

}  // namespace kerf::drive
