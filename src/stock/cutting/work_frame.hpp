#pragma once

#include <optional>
#include <vector>

#include "base/point.hpp"
#include "motion/axis_setup.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// A rotary axis that turns the work: positive turns the tool relative to the work positively about
/// `direction` through `point` (ISO 841). Machine coordinates with all rotary axes at 0.
struct WorkTurn {
  base::Axis axis{};
  Vec3 direction;
  Vec3 point;
};

/// Where a tool is seen from the work.
struct Pose {
  Vec3 tip;
  Vec3 axis{0, 0, 1};  ///< unit, from the tip up along the tool
};

/// From the targets of motions to the frame of the stock (stock.md §2.4): that of the work with all
/// rotary axes at 0, its origin at the stock's zero.
class WorkFrame {
 public:
  /// `turns` in the order in which they carry each other, the one that carries all others first.
  /// An axis of space that the machine lacks stays at 0.
  WorkFrame(const motion::AxisSetup& axes, std::vector<WorkTurn> turns);

  void set_zero(Vec3 zero) { zero_ = zero; }
  [[nodiscard]] Vec3 zero() const { return zero_; }

  /// The same of work whose turns mean nothing, as it is one of revolution.
  [[nodiscard]] WorkFrame still() const;
  /// `axis`: of the tool in the machine.
  [[nodiscard]] Pose pose(const base::TipPoint& tip, Vec3 axis = {0, 0, 1}) const;
  /// A direction of the machine while the rotary axes stand as at `tip`.
  [[nodiscard]] Vec3 turned(Vec3 direction, const base::AxisVector& tip) const;
  /// One of the work's rotary axes stands elsewhere at the second place.
  [[nodiscard]] bool turns_between(const base::AxisVector& a, const base::AxisVector& b) const;
  /// Turns of all the work's rotary axes between two places, added up.
  [[nodiscard]] double turn_rad(const base::AxisVector& a, const base::AxisVector& b) const;
  /// No tip on the way between two places is farther than that from any axis that turns the work.
  [[nodiscard]] double lever(const base::AxisVector& a, const base::AxisVector& b) const;
  /// X Y Z of a vector of the machine.
  [[nodiscard]] Vec3 in_space(const base::AxisVector& vector) const;

 private:
  std::array<std::optional<base::Axis>, 3> linear_;
  std::vector<WorkTurn> turns_;
  Vec3 zero_;
};

}  // namespace kerf::stock
