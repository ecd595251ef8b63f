#pragma once

#include <array>
#include <cstdint>

#include "base/axes.hpp"

namespace kerf::drive {

/// Motors of the two-link arm, in the order of the machine's axes: forearm, upper arm, wheel, lift.
enum class ArmAxis : std::uint8_t { theta1, theta2, theta3, z };

inline constexpr std::size_t kArmAxes = 4;

constexpr base::Axis axis_of(ArmAxis axis) {
  return static_cast<base::Axis>(static_cast<std::uint8_t>(axis));
}

/// A signed number of pulses for each motor of the arm.
struct ArmCounts {
  std::array<std::int64_t, kArmAxes> values{};

  constexpr std::int64_t& operator[](ArmAxis axis) { return values[index(axis_of(axis))]; }
  constexpr std::int64_t operator[](ArmAxis axis) const { return values[index(axis_of(axis))]; }
  friend bool operator==(const ArmCounts&, const ArmCounts&) = default;
};

}  // namespace kerf::drive
