#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "drive/arm_axis.hpp"
#include "drive/return_to_start.hpp"
#include "drive/slow_move.hpp"

namespace kerf::drive {

/// Most pulses of a fast record; those of a field are kMostTripletPulses.
inline constexpr std::int64_t kMostFastPulses = 65535;

/// A number of pulses with its direction bit, which is kept also where nothing moves: -0 is not 0.
struct PulseField {
  std::uint16_t pulses = 0;
  bool negative = false;

  [[nodiscard]] constexpr std::int64_t count() const {
    return negative ? -std::int64_t{pulses} : std::int64_t{pulses};
  }
  friend bool operator==(const PulseField&, const PulseField&) = default;
};

/// Travel of one axis alone, 0 to kMostFastPulses.
struct FastRecord {
  ArmAxis axis = ArmAxis::theta1;
  PulseField field;

  [[nodiscard]] constexpr FastMove move() const { return {axis, field.count()}; }
  friend bool operator==(const FastRecord&, const FastRecord&) = default;
};

/// A cut: the wheel turns, then both arms move together. Each field is 0 to kMostTripletPulses.
struct Triplet {
  /// In the order of the bytes.
  static constexpr std::array kAxes = {ArmAxis::theta3, ArmAxis::theta1, ArmAxis::theta2};

  std::array<PulseField, 3> fields{};
  /// What the bytes say of their axes; anything but kAxes only where nobody looks at it.
  std::array<ArmAxis, 3> axes = kAxes;

  [[nodiscard]] constexpr SlowMove move() const {
    return {fields[0].count(), fields[1].count(), fields[2].count()};
  }
  friend bool operator==(const Triplet&, const Triplet&) = default;
};

/// One entry of the pattern database (docs/pattern.md). Value type.
using PatternRecord = std::variant<FastRecord, Triplet>;

}  // namespace kerf::drive
