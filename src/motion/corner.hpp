#pragma once

#include <optional>

#include "motion/cell_limits.hpp"
#include "motion/curve.hpp"

namespace kerf::motion {

/// How far from the corner its rounding begins and ends, and the rounding itself: a curve of length
/// 2 `reach` that leaves the first curve and joins the second with equal direction and curvature.
struct Rounding {
  double reach = 0;
  Curve curve;
};

/// What happens where one curve ends and the next begins.
struct Corner {
  enum class Kind : std::uint8_t {
    none,     ///< the axes go on as they are
    rounded,  ///< by `rounding`
    sharp     ///< it cannot be rounded: the axes come to rest
  };
  Kind kind = Kind::none;
  Rounding rounding;
};

/// Rounds corners, as little as the feed needs and at most within the tolerance.
///
///    ────────╮    ·          The rounding replaces `reach` of both curves and meets them with
///    their
///      reach  ╲   |          directions, with limited jerk also with their curvature. Between
///              ╲  | reach    lines whose directions differ by Δu it is the parabola q'' = Δu/(2
///               │ |          reach), |Δu| reach / 4 away from the corner; with limited jerk the
///               │ |          polynomial of degree 5 whose second derivative is the hat
///                            Δu 6x(1 - x)/(2 reach), 3/16 |Δu| reach away.
///
class CornerRounder {
 public:
  CornerRounder(const CellLimits& limits, std::size_t axes, std::array<bool, base::kMaxAxes> linear)
      : limits_(limits), axes_(axes), linear_(linear) {}

  /// The corner between the end of `in` and the begin of `out`: up to `most_reach` of each is
  /// replaced. `feed`: speed that is wanted there. `tolerance_mm`: most that the rounding may leave
  /// the curves; infinite: any.
  [[nodiscard]] Corner between(const Curve& in, const Curve& out, double most_reach, double feed,
                               double tolerance_mm) const;

 private:
  [[nodiscard]] double wanted_reach(const base::AxisVector& turn, const base::AxisVector& bend,
                                    double feed) const;
  [[nodiscard]] double size(const base::AxisVector& difference) const;
  [[nodiscard]] bool stays_near(const Rounding& rounding, const Curve& in, const Curve& out,
                                double tolerance) const;
  [[nodiscard]] std::optional<Rounding> round(const Curve& in, const Curve& out, double reach,
                                              double tolerance) const;

  const CellLimits& limits_;
  std::size_t axes_;
  std::array<bool, base::kMaxAxes> linear_;
};

}  // namespace kerf::motion
