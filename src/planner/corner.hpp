#pragma once

#include "motion/axis_norms.hpp"
#include "motion/curve.hpp"
#include "planner/cell_limits.hpp"
#include "planner/corner_time.hpp"
#include "planner/follower.hpp"

namespace kerf::planner {

/// How far from the corner its rounding begins and ends, and the rounding itself: a curve of length
/// 2 `reach` that leaves the first curve and joins the second with equal direction and curvature.
struct Rounding {
  double reach = 0;
  motion::Curve curve;
};

/// What happens where one curve ends and the next begins.
struct Corner {
  enum class Kind : std::uint8_t {
    none,     ///< the axes go on as they are
    rounded,  ///< by `rounding`
    sharp     ///< the axes come to rest: it cannot be rounded, or a stop takes less time
  };
  Kind kind = Kind::none;
  Rounding rounding;
};

/// How a corner may be passed.
struct Passage {
  double feed_in = 0;       ///< of the first curve, and
  double feed_out = 0;      ///< of the second
  double most_reach = 0;    ///< so much of each may be replaced
  double tolerance_mm = 0;  ///< most that the rounding may leave the curves; infinite: any, and
                            ///< then the axes do not stop for time's sake
};

/// Rounds corners, as little as the feed needs, at most within the tolerance, and so that they take
/// the least time.
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
  /// The limits are those of the driven axes; `follower` says how these move. Both must outlive
  /// this.
  CornerRounder(const CellLimits& limits, std::size_t axes, const motion::LinearAxes& linear,
                Follower& follower)
      : limits_(limits), axes_(axes), norms_{linear, axes}, follower_(follower) {}

  /// The corner between the end of `in` and the begin of `out`.
  [[nodiscard]] Corner between(const motion::Curve& in, const motion::Curve& out,
                               const Passage& passage) const;

 private:
  [[nodiscard]] double wanted_reach(const base::JointJet& end, const base::JointJet& begin,
                                    const Passage& passage) const;
  [[nodiscard]] Corner best_of(const motion::Curve& in, const motion::Curve& out,
                               const CornerTime& time, double reach, double tolerance) const;
  [[nodiscard]] bool stays_near(const Rounding& rounding, const motion::Curve& in,
                                const motion::Curve& out, double tolerance) const;
  [[nodiscard]] bool is_surely_near(const Rounding& rounding, const motion::CurveBounds& bounds,
                                    const motion::Curve& in, const motion::Curve& out,
                                    double tolerance) const;
  [[nodiscard]] double bend_of(const motion::Curve& curve, double from, double to) const;
  [[nodiscard]] Rounding round(const motion::Curve& in, const motion::Curve& out,
                               double reach) const;

  const CellLimits& limits_;
  std::size_t axes_;
  motion::AxisNorms norms_;
  Follower& follower_;
};

}  // namespace kerf::planner
