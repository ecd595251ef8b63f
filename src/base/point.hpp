#pragma once

#include <algorithm>
#include <initializer_list>

#include "base/axes.hpp"

namespace kerf::base {

/// The coordinate systems in which Kerf says where something is. Each is that of one machine; mm on
/// linear axes, degrees on rotary ones.
namespace frame {
/// What the words of the program say (#5001): work offsets, shifts, scaling, mirror and rotation in
/// force are not in it.
struct Program {};
/// The programmed path in the machine's coordinate system, without tool length and without cutter
/// compensation.
struct Path {};
/// The tip of the tool in the machine's coordinate system: compensated, tool length left out. What
/// motions and set-points are about.
struct Tip {};
/// Machine coordinates: the tip with the tool length (#5021). Limits of travel count in it.
struct Machine {};
/// The driven axes, in the order of the machine file: those of the program, or joints of a linkage.
struct Joints {};
}  // namespace frame

/// A point of one coordinate system. Points of two systems do not mix, and numbers are a point only
/// where somebody says so: what leads from one system to the other has a name. The difference of
/// two points, and what is added to one, is a way: a plain AxisVector. What is the same in every
/// system takes points as such.
template <typename Frame>
struct Point : AxisVector {
  constexpr Point() = default;
  constexpr explicit Point(const AxisVector& at) : AxisVector(at) {}
  /// Numbers that are written out are a point of the system that is asked for. At most kMaxAxes.
  constexpr Point(std::initializer_list<double> numbers) {
    std::copy(numbers.begin(), numbers.end(), values.begin());
  }
  template <typename Other>
  Point(const Point<Other>&) = delete;

  /// The numbers alone. Where they are the same in another system, as those of joints and tip on a
  /// machine without a linkage, that is said with them: TipPoint(joints.numbers()).
  [[nodiscard]] constexpr const AxisVector& numbers() const { return *this; }

  friend constexpr bool operator==(const Point& a, const Point& b) {
    return static_cast<const AxisVector&>(a) == static_cast<const AxisVector&>(b);
  }
  friend constexpr AxisVector operator-(const Point& to, const Point& from) {
    return static_cast<const AxisVector&>(to) - static_cast<const AxisVector&>(from);
  }
  friend constexpr Point operator+(const Point& from, const AxisVector& way) {
    return Point(static_cast<const AxisVector&>(from) + way);
  }
  friend constexpr Point operator-(const Point& from, const AxisVector& way) {
    return Point(static_cast<const AxisVector&>(from) - way);
  }
};

// Without these, two points of different systems would do as two vectors.
template <typename A, typename B>
void operator==(const Point<A>&, const Point<B>&) = delete;
template <typename A, typename B>
void operator-(const Point<A>&, const Point<B>&) = delete;
template <typename A, typename B>
void operator+(const Point<A>&, const Point<B>&) = delete;

using ProgramPoint = Point<frame::Program>;
using PathPoint = Point<frame::Path>;
using TipPoint = Point<frame::Tip>;
using MachinePoint = Point<frame::Machine>;
using JointPoint = Point<frame::Joints>;

/// Where the tip is in machine coordinates while `length` of the tool is in force, and back.
[[nodiscard]] constexpr MachinePoint machine_of(const TipPoint& tip, const AxisVector& length) {
  return MachinePoint(tip.numbers() + length);
}
[[nodiscard]] constexpr TipPoint tip_of(const MachinePoint& machine, const AxisVector& length) {
  return TipPoint(machine.numbers() - length);
}

}  // namespace kerf::base
