#pragma once

#include <optional>

#include "control/core/outlet.hpp"
#include "geometry/vec2.hpp"
#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// The last station before Outlet. While a surface is in force everything before it counts in the
/// plane of that, where the rotary axis counts mm: corners and cutter compensation know nothing of
/// a face or a cylinder. Here lines and arcs become moves on the surface.
class SurfaceOutlet {
 public:
  /// All must outlive this.
  SurfaceOutlet(const motion::AxisSetup& axes, Outlet& outlet) : axes_(axes), outlet_(outlet) {}

  /// As Outlet::let_out(); `from` is in the plane.
  [[nodiscard]] bool let_out(const motion::Motion& motion, const base::TipPoint& from,
                             const base::Place* place = nullptr);
  /// As Outlet::admits().
  [[nodiscard]] bool admits(const motion::Motion& motion, const base::TipPoint& from);
  void reset() { outlet_.reset(); }

  /// From now on points are in the plane; the tip stands at `tip` of the machine.
  void begin(const motion::Surface& surface, const base::TipPoint& tip);
  /// Points are the machine's again.
  void end() { surface_.reset(); }
  [[nodiscard]] const motion::Surface* surface() const { return surface_ ? &*surface_ : nullptr; }

  /// The same place in the plane and on the machine. Precondition: surface().
  [[nodiscard]] base::TipPoint in_plane(base::TipPoint tip) const;
  [[nodiscard]] const base::TipPoint& on_machine() const { return tip_; }

 private:
  [[nodiscard]] motion::Motion translated(const motion::Motion& motion) const;
  [[nodiscard]] geometry::Vec2 flat(double first, double rotary) const;

  const motion::AxisSetup& axes_;
  Outlet& outlet_;
  std::optional<motion::Surface> surface_;
  base::TipPoint tip_;  // of the machine, while there is a surface
};

}  // namespace kerf::control
