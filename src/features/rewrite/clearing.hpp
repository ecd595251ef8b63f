#pragma once

#include <map>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::features {

/// A corner of the wall round which a way turns sharply.
struct Mitre {
  contour::Vec2 centre{};  ///< that corner
  double length = 1;       ///< of the way's corner from it, in distances of the way from the wall
};

struct LoopsAtDistance {
  std::vector<contour::Contour> loops{};
  std::vector<Mitre> mitres{};
};

/// What the loops of a layer clear: the inside of a region, or (side milling) what is round it.
struct Clearing {
  contour::Region region{};
  bool is_outside = false;
  double tool_radius = 0;
  bool has_sharp_corners = false;  ///< the way turns sharply round corners of the wall, not in arcs
  /// Those that loops_at() has made, by their distances: it is asked for each several times. What
  /// loops_at() returns holds until it is asked for another one.
  mutable std::map<double, LoopsAtDistance> known_loops{};
};

/// The ways of the tool's centre at `distance` from the wall, with what is cleared on their left;
/// none: it is too far.
[[nodiscard]] const std::vector<contour::Contour>& loops_at(const Clearing& clearing,
                                                            double distance);

/// At which distances from the wall loops go, and what they leave.
struct LoopDistances {
  std::vector<double> from_wall{};  ///< ascending; empty: the tool does not fit
  double rest_mm2 = 0;              ///< that a disc of the tool could reach, and no loop does
  contour::Vec2 rest_at{};          ///< a corner of it
};
/// Those of `wanted` (ascending) as far as there are loops, behind them `step` apart until a disc
/// of the tool has been wherever it can be.
[[nodiscard]] LoopDistances distances_of(const Clearing& clearing,
                                         const std::vector<double>& wanted, double step);

/// Between a contour and its islands.
[[nodiscard]] contour::Region region_between(const contour::Contour& outer,
                                             const std::vector<contour::Contour>& islands);
/// What a disc can reach of a region.
[[nodiscard]] contour::Region opened(const contour::Region& region, double radius);

/// What a disc of the tool could reach, and these ways of its centre do not, but for hairs.
[[nodiscard]] contour::Region rest_behind(const Clearing& clearing,
                                          const std::vector<contour::Contour>& ways);

/// Whether the tool may go straight from one point to the other without touching the wall.
[[nodiscard]] bool is_clear(const Clearing& clearing, contour::Vec2 from, contour::Vec2 to);

}  // namespace kerf::features
