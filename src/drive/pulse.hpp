#pragma once

#include <cstdint>

#include "base/axes.hpp"

namespace kerf::drive {

enum class Direction : std::int8_t { negative = -1, positive = 1 };

constexpr std::int64_t sign(Direction direction) { return static_cast<std::int64_t>(direction); }
constexpr Direction direction_of(double amount) {
  return amount < 0 ? Direction::negative : Direction::positive;
}

/// One step of one motor. The motor steps on the rising edge.
struct Pulse {
  std::int64_t time_ns = 0;    ///< of the rising edge, from the start
  std::uint32_t width_ns = 1;  ///< until the falling edge, >= 1; 2^32-1 also stands for longer
  base::Axis axis{};
  Direction direction = Direction::positive;

  friend bool operator==(const Pulse&, const Pulse&) = default;
};

}  // namespace kerf::drive
