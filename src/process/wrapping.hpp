#pragma once

#include <optional>
#include <vector>

#include "base/point.hpp"
#include "motion/axis_setup.hpp"
#include "process/wrapped_surface.hpp"

namespace kerf::process {

/// A target of a five-axis head; `via`: it goes there on an arc in space.
struct WrappedTarget {
  base::TipPoint to;
  std::optional<base::TipPoint> via;
};

/// A drawing on a surface, made by a head that holds its beam square to it (axes X Y Z A C).
class Wrapping {
 public:
  /// The axes must outlive it, and have those letters.
  Wrapping(const Wrap& wrap, const motion::AxisSetup& axes, double tolerance_mm);

  /// Where the tip is at a place of the drawing, `lift` mm above the surface, with the angles that
  /// are nearest to those of `before`.
  [[nodiscard]] base::TipPoint tip(Vec2 at, double lift, const base::TipPoint& before) const;
  /// Along an edge on the surface: exactly where it goes round the axis or along it, else by lines
  /// with their focus within the tolerance of the surface and the beam within `normal_deg` of
  /// square.
  [[nodiscard]] std::vector<WrappedTarget> cut(const contour::Edge& edge,
                                               const base::TipPoint& before) const;
  /// Out along the normal, over the surface, and in again.
  [[nodiscard]] std::vector<base::TipPoint> travel(Vec2 from, Vec2 to,
                                                   const base::TipPoint& before) const;
  [[nodiscard]] const WrappedSurface& surface() const { return surface_; }

 private:
  [[nodiscard]] std::vector<base::TipPoint> chords(const contour::Edge& edge, double lift,
                                                   double count,
                                                   const base::TipPoint& before) const;
  [[nodiscard]] bool are_near(const contour::Edge& edge, double lift, double count, double most_mm,
                              const base::TipPoint& before) const;
  [[nodiscard]] double chord_count(const contour::Edge& edge, double lift, double most_mm,
                                   const base::TipPoint& before) const;
  [[nodiscard]] Vec3 place(const base::TipPoint& tip) const;

  Wrap wrap_;
  WrappedSurface surface_;
  double tolerance_mm_;
  base::Axis x_, y_, z_, a_, c_;
};

}  // namespace kerf::process
