#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/vec3.hpp"
#include "motion/axis_norms.hpp"
#include "motion/axis_setup.hpp"
#include "motion/curve.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

/// The curves of single moves as they are programmed.
class MoveCurves {
 public:
  /// The axes must outlive this.
  explicit MoveCurves(const AxisSetup& axes)
      : axes_(axes), norms_{linear_axes(axes), axes.count()} {
    curves_.reserve(kOnFace);
  }

  /// The curves of a move in their order, until the next call: one; of an arc in space one from
  /// each point given to the next; of a move on a face many (SurfacePath); of a rapid whose axes
  /// keep their own rates one until each of them is done; of one over turning work that of
  /// TurningRapid; none when it goes nowhere. `from` is where the tip stands. A motion without a
  /// target goes nowhere.
  [[nodiscard]] std::span<const Curve> of(const base::TipPoint& from, const Motion& motion);

 private:
  static constexpr std::size_t kOnFace = 128;  // as many as hardly a move there has

  void add_rapid(const Rapid& rapid);
  void add_legs(const base::TipPoint& to);
  void add_line(const base::TipPoint& to);
  void add_arc(const Arc& arc);
  void add_space_arc(const SpaceArc& arc);
  void add_surface_move(const SurfaceMove& move);
  void add(const Curve& curve);
  void place(base::AxisVector& vector, geometry::Vec3 xyz) const;

  const AxisSetup& axes_;
  AxisNorms norms_;
  base::TipPoint at_;  // where the next curve begins
  std::vector<Curve> curves_;
};

}  // namespace kerf::motion
