#pragma once

#include "geometry/vec2.hpp"

namespace kerf::control {

/// The tool beside a path that is compensated: where its centre runs, and which of its points the
/// control moves. mm, in the plane.
struct Cutter {
  double offset = 0;     ///< of the centre from the path; > 0 lies to the left of it
  geometry::Vec2 tip{};  ///< from the centre to the point that moves: of a lathe the imaginary tip

  friend bool operator==(const Cutter&, const Cutter&) = default;
};

}  // namespace kerf::control
