#pragma once

#include <array>
#include <cstdint>

#include "motion/axis_setup.hpp"

namespace kerf::planner {

/// The points of a line in the literal mode, which steps X Y and Z apart (docs/motion.md,
/// "Literal"):
///
///   Z │●                     Each chain of axes goes on by `step` until its end and waits there:
///     │  ╲● ·                from (0, 0) to (3, -1) first both go, then X alone. So the points
///     │     ╲● ─ ● ─ ●       leave the line, which is what the mode is there to show.
///     └────────────── X      Other axes go in proportion to the number of the point.
///
/// For comparison and teaching only. Value type.
class LiteralLine {
 public:
  LiteralLine() = default;
  /// step_mm > 0.
  LiteralLine(const base::TipPoint& from, const base::TipPoint& to, double step_mm,
              const motion::AxisSetup& axes);

  /// Number of points: the last one is the end, the start is none. 0: neither chain moves.
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// 1 <= n <= count().
  [[nodiscard]] base::TipPoint at(std::uint64_t n) const;

 private:
  /// Axes that step together, `step` of each.
  struct Chain {
    base::AxisVector step;
    std::uint64_t count = 0;  // steps to the end, the last of which may be shorter
  };
  static Chain chain(const base::AxisVector& way, double step_mm);

  base::TipPoint from_, to_;
  Chain plane_;
  Chain height_;
  base::AxisVector others_;  // the way of all other axes
  std::uint64_t count_ = 0;
};

}  // namespace kerf::planner
