#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "geometry/vec3.hpp"
#include "motion/curve.hpp"

namespace kerf::motion {

/// The curves of a single move as it is programmed, in their order: one; of an arc in space one
/// from each point given to the next; none when the move goes nowhere. Value type.
class MoveCurves {
 public:
  /// `from` is where the tip stands. A motion without a target goes nowhere.
  MoveCurves(const control::AxisSetup& axes, const base::AxisVector& from,
             const control::Motion& motion);

  [[nodiscard]] std::span<const Curve> curves() const { return {curves_.data(), count_}; }

 private:
  void add_line(const base::AxisVector& to);
  void add_arc(const control::Arc& arc);
  void add_space_arc(const control::SpaceArc& arc);
  void add(const Curve& curve) { curves_[count_++] = curve; }
  void place(base::AxisVector& vector, geometry::Vec3 xyz) const;

  const control::AxisSetup& axes_;
  base::AxisVector from_;
  std::array<Curve, 3> curves_;
  std::size_t count_ = 0;
};

}  // namespace kerf::motion
