#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "geometry/space_arc.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// The way of a SpaceArc from where the tool stands: X, Y and Z follow the circle, every other axis
/// goes linearly with the angle from one of the points given to the next.
///
///     a │      via              a(θ) = a1 + θ / α12 (a2 - a1)               θ < α12
///       │    ,´   `,            a(θ) = a2 + (θ - α12) / α23 (a3 - a2)       θ >= α12
///       │  ,´       `to
///       └───────┴────┴── θ      so a is continuous, and its rate changes at once at `via`.
///       0      α12  α12+α23
///
/// An axis X, Y or Z that the machine lacks is at 0. Value type.
class SpaceArcPath {
 public:
  /// One of the points given, and the angle at which the tool passes it.
  struct Knot {
    double angle_rad = 0;
    base::TipPoint point;
  };

  /// Precondition: the points carry an arc or a circle (geometry::SpaceArc). Whoever makes a
  /// SpaceArc looks.
  SpaceArcPath(const AxisSetup& axes, const base::TipPoint& from, const SpaceArc& arc);

  [[nodiscard]] const geometry::SpaceArc& circle() const { return circle_; }
  /// From the start to the end, three, or four of a full circle.
  [[nodiscard]] std::span<const Knot> knots() const { return {knots_.data(), knot_count_}; }
  /// Where the tool is at an angle, clamped to [0, sweep]. At the angle of a knot exactly there.
  [[nodiscard]] base::TipPoint at(double angle_rad) const;

  /// Calls `reach(point)` with the ends of the chords that stand for the way, in order. Every knot
  /// is such an end; between two of them they are equal, each over an angle of at most `most_rad`.
  template <typename Reach>
  void chords(double most_rad, Reach&& reach) const {
    for (std::size_t i = 1; i < knot_count_; ++i) {
      const double begin = knots_[i - 1].angle_rad;
      const double sweep = knots_[i].angle_rad - begin;
      const double count = std::max(1.0, std::ceil(sweep / most_rad - 1e-9));
      for (double n = 1; n < count; ++n) reach(at(begin + sweep * n / count));
      reach(knots_[i].point);
    }
  }

 private:
  static constexpr std::size_t kMostKnots = 4;

  std::array<std::optional<base::Axis>, 3> xyz_;
  geometry::SpaceArc circle_;
  std::array<Knot, kMostKnots> knots_;
  std::size_t knot_count_ = 0;
};

}  // namespace kerf::motion
