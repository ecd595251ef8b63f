#pragma once

#include "stock/cutting/workpiece.hpp"

namespace kerf::stock {

/// How a workpiece is clamped anew (stock.md §2.2): turned about its own zero by A about X, then B
/// about Y, then C about Z, all of them fixed axes, then moved. Degrees, anticlockwise seen from
/// the end of the axis; mm.
struct Placement {
  Vec3 move;
  Vec3 turn_deg;

  friend bool operator==(const Placement&, const Placement&) = default;
};

/// Where a point comes to; exact but for the addition where all turns are multiples of 90 degrees.
class Placing {
 public:
  explicit Placing(const Placement& placement);

  [[nodiscard]] Vec3 operator()(Vec3 point) const { return turned(point) + move_; }
  /// Without the move.
  [[nodiscard]] Vec3 turned(Vec3 v) const { return v.x * x_ + v.y * y_ + v.z * z_; }
  /// Each axis comes to lie along one.
  [[nodiscard]] bool is_square() const;

 private:
  Vec3 x_, y_, z_;  // where the axes come to
  Vec3 move_;
};

/// A box or a round piece that is turned by other than multiples of 90 degrees becomes a mesh: a
/// round one has as many sides as it takes to be within kRoundness_mm, and its exact volume.
[[nodiscard]] Workpiece placed(const Workpiece& piece, const Placement& placement);

inline constexpr double kRoundness_mm = 1e-4;

}  // namespace kerf::stock
