#pragma once

#include <vector>

#include "geometry/contour/contour.hpp"

namespace kerf::parts {

using contour::Contour;
using geometry::Vec2;

/// The wall of something on a drawing, counterclockwise, and its offsets, each by a formula of its
/// own: what is compared with the offsets of the rooms shall not be made by them.
class Outline {
 public:
  /// Corners in order, counterclockwise; lines between them. Those that turn left are rounded by
  /// `corner`. Convex, or with one corner that turns right, as an L has it.
  [[nodiscard]] static Outline polygon(std::vector<Vec2> corners, double corner = 0);
  /// All points that far from the line between two points; of one point a circle.
  [[nodiscard]] static Outline stadium(Vec2 a, Vec2 b, double radius);
  [[nodiscard]] static Outline circle(Vec2 middle, double radius) {
    return stadium(middle, middle, radius);
  }
  /// Round `middle`, turned by an angle.
  [[nodiscard]] static Outline rectangle(Vec2 middle, Vec2 half, double angle_rad,
                                         double corner = 0);

  [[nodiscard]] bool is_circle() const { return corners_.empty() && a_ == b_; }
  [[nodiscard]] bool is_polygon() const { return !corners_.empty(); }
  [[nodiscard]] Vec2 middle() const;
  /// Of the largest disc inside; a lower bound of it where a corner turns right.
  [[nodiscard]] double inner_radius() const;

  [[nodiscard]] Contour drawn() const;
  /// What a tool of that radius leaves of it inside: corners are rounded.
  [[nodiscard]] Contour milled(double radius) const;
  /// The path of points `distance` inside of it; no vertices: there is none.
  [[nodiscard]] Contour inset(double distance) const;
  /// The path outside of it, round its corners; convex ones alone.
  [[nodiscard]] Contour outset(double distance) const;

 private:
  std::vector<Vec2> corners_;
  double corner_ = 0;
  Vec2 a_{};
  Vec2 b_{};
  double radius_ = 0;
};

}  // namespace kerf::parts
