#pragma once

namespace kerf::contour {

/// The one tolerance of this room: points that are no farther from each other are one, curves that
/// run no farther beside each other are one, what comes no nearer than this to a border is inside
/// or outside. It needs coordinates of at most 1e6 mm: beyond, doubles are coarser.
inline constexpr double kSame_mm = 1e-9;

/// A loop of less area is none.
inline constexpr double kNoArea_mm2 = 1e-9;

/// A contour that has a larger coordinate, or one that is no number, is left out of everything.
inline constexpr double kFarthest_mm = 1e9;

}  // namespace kerf::contour
