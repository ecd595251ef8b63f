#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::drawing {

using geometry::Vec2;

struct Round {
  Vec2 centre;
  double radius = 0;
  double error = 0;  ///< how far the path is from it at most
};

/// Curves that became a path, as long as nothing else was drawn.
struct Curves {
  bool all = true;
  double error = 0;  ///< the largest bound of their arcs
  std::vector<std::array<Vec2, 4>> cubics;
  std::size_t count = 0;  ///< cubics holds the first ones alone, and none where others were drawn

  void take(const std::array<Vec2, 4>& cubic);
  void clear();
};

/// The circle that all of a closed path lies on within `most` mm, and which it goes round once:
/// that of its longest arc, or the one through the places where its cubics meet. What is measured
/// are the cubics themselves, where all were, or else the arcs, with their own bound. None, where
/// one of its edges is a line or turns the other way.
[[nodiscard]] std::optional<Round> round_path(const std::vector<contour::Vertex>& vertices,
                                              const Curves& curves, double most);

/// How far a cubic is from a circle at most.
[[nodiscard]] double distance_bound(const std::array<Vec2, 4>& cubic, Vec2 centre, double radius);

}  // namespace kerf::drawing
