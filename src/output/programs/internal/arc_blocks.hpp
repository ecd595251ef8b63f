#pragma once

#include <optional>

#include "geometry/space_arc.hpp"
#include "motion/motion.hpp"
#include "motion/plane_axes.hpp"
#include "output/programs/internal/move_blocks.hpp"

namespace kerf::output {

/// Writes arcs of a posted program: as blocks with I, J, K where the file's digits can say them, as
/// chords and full circles where they cannot.
class ArcBlocks {
 public:
  /// How far chords leave their arc at most, rounding of the coordinates apart.
  static constexpr double kChordTolerance_mm = 0.001;
  /// By how much the radius of an arc with I, J, K changes at most.
  static constexpr double kRadiusTolerance_mm = 0.0005;

  /// It must outlive this.
  explicit ArcBlocks(MoveBlocks& moves) : moves_(moves) {}

  /// Nothing where the machine lacks an axis of the plane.
  void write(const motion::Arc& arc);
  void write(const motion::SpaceArc& arc);

 private:
  [[nodiscard]] std::optional<double> flat_rise(const motion::Arc& arc,
                                                const motion::PlaneAxes& plane) const;
  void flat_arc(const motion::Arc& arc, const motion::PlaneAxes& plane, double rise);
  void spiral(const motion::Arc& arc, const motion::PlaneAxes& plane, double per_minute);
  void rest_of_turn(const motion::Arc& arc, const motion::PlaneAxes& plane, double sweep_rad,
                    double per_minute);
  void full_circles(const motion::Arc& arc, const motion::PlaneAxes& plane, double per_minute);
  void sweep(const motion::Arc& arc, const motion::PlaneAxes& plane, double per_minute);
  [[nodiscard]] bool stays_in(const motion::PlaneAxes& plane, const motion::SpaceArc& arc) const;
  [[nodiscard]] std::optional<motion::Arc> plane_arc(const motion::SpaceArc& arc,
                                                     const geometry::SpaceArc& circle,
                                                     motion::Plane plane) const;

  MoveBlocks& moves_;
};

}  // namespace kerf::output
