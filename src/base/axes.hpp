#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf::base {

/// Most axes that one machine can have.
inline constexpr std::size_t kMaxAxes = 8;

/// Position of an axis in the machine's own order, from 0.
enum class Axis : std::uint8_t {};

constexpr std::size_t index(Axis axis) { return static_cast<std::size_t>(axis); }

/// One number per axis of a machine, in its order: mm on linear axes, degrees on rotary ones.
/// Entries beyond the machine's axes are 0.
struct AxisVector {
  std::array<double, kMaxAxes> values{};

  constexpr double& operator[](Axis axis) { return values[index(axis)]; }
  constexpr double operator[](Axis axis) const { return values[index(axis)]; }
  friend bool operator==(const AxisVector&, const AxisVector&) = default;

  friend constexpr AxisVector operator+(AxisVector a, const AxisVector& b) {
    for (std::size_t i = 0; i < kMaxAxes; ++i) a.values[i] += b.values[i];
    return a;
  }
  friend constexpr AxisVector operator-(AxisVector a, const AxisVector& b) {
    for (std::size_t i = 0; i < kMaxAxes; ++i) a.values[i] -= b.values[i];
    return a;
  }
};

/// A set of axes, one bit each.
using AxisSet = std::uint8_t;

constexpr AxisSet only(Axis axis) { return static_cast<AxisSet>(1U << index(axis)); }
constexpr bool contains(AxisSet set, Axis axis) {
  return (static_cast<unsigned>(set) >> index(axis) & 1U) != 0;
}

}  // namespace kerf::base
