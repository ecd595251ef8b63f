#pragma once

#include <optional>
#include <vector>

#include "stock/tool/profile.hpp"

namespace kerf::stock::dexel {

/// A convex piece of a tool: a body of revolution between two planes across its axis, in the frame
/// of the tool (tip at 0, z up its axis), mm. Its points have
///
///   x² + y² <= square + 2 slope z + bend z²,   low <= z <= high
///
/// A cone r = a + k z (a cylinder with k = 0) has square a², slope a k, bend k², and r >= 0 between
/// the planes; a ball of radius r around z = c has square r² - c², slope c, bend -1.
struct Solid {
  double square = 0;
  double slope = 0;
  double bend = 0;
  double low = 0;
  double high = 0;
  /// Cones: a and k; balls: radius and height of the centre.
  double first = 0;
  double second = 0;
  bool is_ball = false;
  /// Whether its part of the tool has a face here, or goes on with another solid.
  bool ends_low = true;
  bool ends_high = true;
  ToolPart part = ToolPart::edge;

  [[nodiscard]] static Solid cone(double a, double k, double low, double high);
  [[nodiscard]] static Solid ball(double radius, double centre, double low, double high);

  [[nodiscard]] double radius_at(double z) const;
  [[nodiscard]] double widest() const;
  /// The planes cut nothing off a ball.
  [[nodiscard]] bool is_whole_ball() const;
  /// Of the middle of what it is: where its turning moves it least.
  [[nodiscard]] double middle() const;
  /// Largest distance of a point of it from the middle.
  [[nodiscard]] double lever() const;
};

/// Made larger on all sides by `by` (or more, at its rims); holds every point within `by` of it.
[[nodiscard]] Solid grown(const Solid& solid, double by);
/// Made smaller by `by` on all sides, where it goes on with another solid as well. None: nothing is
/// left of it.
[[nodiscard]] std::optional<Solid> shrunk(const Solid& solid, double by);
/// Made smaller by `by` where its part of the tool ends.
[[nodiscard]] std::optional<Solid> shrunk_at_faces(const Solid& solid, double by);

/// The tool as a stack of convex pieces, upwards. Arcs whose centre is not on the axis become
/// cones that are within `tolerance_mm` of them on either side.
[[nodiscard]] std::vector<Solid> solids_of(const Profile& profile, double tolerance_mm);

}  // namespace kerf::stock::dexel
