#pragma once

#include <array>
#include <cstdint>

#include "base/place.hpp"
#include "geometry/vec3.hpp"

namespace kerf::training {

/// What a cut is made with.
struct CutWith {
  std::uint32_t tool = 0;
  double power_percent = 0;  ///< of a beam
  bool spindle_turns = false;
  std::array<double, 2> rotary_deg{};  ///< where the first two rotary axes stand
};

// Places are work coordinates, mm. Of a turned part: Z, 0, and how far from the axis beyond the
// bar, so that its bar has its top at 0 as milled work has, and lies where x is below 0.

/// A short straight piece of a cut path.
struct Cut {
  geometry::Vec3 from;
  geometry::Vec3 to;
  CutWith with;
  base::FileId file = base::kNoFile;
  std::uint32_t line = 0;

  [[nodiscard]] double length() const { return geometry::length(to - from); }
  [[nodiscard]] geometry::Vec3 middle() const { return 0.5 * (from + to); }
};

/// A rapid.
struct Stroke {
  geometry::Vec3 from;
  geometry::Vec3 to;
  base::FileId file = base::kNoFile;
  std::uint32_t line = 0;
  std::size_t cuts_before = 0;  ///< how many cuts had been made
};

}  // namespace kerf::training
