#pragma once

#include <vector>

#include "control/core/parameters.hpp"
#include "control/gcode/cycles/turning_passes.hpp"

namespace kerf::control {

/// How a thread leaves the part at its end.
struct RunOut {
  double length = 0;     ///< along Z, mm; 0: none
  double angle_deg = 0;  ///< to Z, above 0 and below 90
};

/// As parameters 5130 and 5131 have it.
[[nodiscard]] RunOut run_out_of(const Parameters& parameters, double lead);

/// One cut of a thread cycle: along X to `from`, the thread to `to` with its run-out, along X back
/// to the radius of `home`, and home (docs/dialect/turning.md, thread cycles).
///
/// The run-out begins its length before the end, on the line of the thread, and goes towards the
/// radius of `home`; it ends where the thread ends along Z, or at that radius if that comes first.
[[nodiscard]] std::vector<TurningMove> thread_cut(geometry::Vec2 home, geometry::Vec2 from,
                                                  geometry::Vec2 to, const RunOut& run_out);

}  // namespace kerf::control
