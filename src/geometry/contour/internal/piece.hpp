#pragma once

#include <array>
#include <cstdint>

#include "geometry/contour/box.hpp"
#include "geometry/contour/internal/point_pool.hpp"

namespace kerf::contour {

/// How often something is gone round, by each of two sets of edges.
struct Winding {
  int first = 0;
  int second = 0;

  friend Winding operator+(Winding a, Winding b) {
    return {a.first + b.first, a.second + b.second};
  }
  friend Winding operator-(Winding a) { return {-a.first, -a.second}; }
  friend Winding operator-(Winding a, Winding b) { return a + -b; }
  friend bool operator==(Winding, Winding) = default;
};

/// A line, or an arc of at most a quarter of a circle that rises or falls throughout: it lies in
/// the rectangle of its ends. In its own frame (x along the chord, y to the left) it is where g =
/// cosine·y - flexure·(x² - chord·x + y²) is 0; near it, g is the distance to the left. This has
/// full precision for any radius, and lines are no special case.
struct Piece {
  PointId from_id = 0;
  PointId to_id = 0;
  std::uint32_t source = 0;  ///< the caller's edge
  Winding passes;            ///< how often it is gone along, backwards counting down
  Vec2 from;
  Vec2 to;
  Vec2 direction;      ///< of the chord, unit length
  double chord = 0;    ///< > 0
  double bulge = 0;    ///< as of an Edge
  double flexure = 0;  ///< half of the curvature, positive counterclockwise
  double cosine = 1;   ///< of half of the swept angle

  [[nodiscard]] Vec2 in_frame(Vec2 point) const {
    const Vec2 arm = point - from;
    return {dot(direction, arm), cross(direction, arm)};
  }
  [[nodiscard]] double side_of(Vec2 in_frame) const {
    return cosine * in_frame.v -
           flexure * (in_frame.u * (in_frame.u - chord) + in_frame.v * in_frame.v);
  }
  /// Where the middle of the arc lies in the frame: 0 of lines, < 0 of counterclockwise arcs.
  [[nodiscard]] double apex() const { return -bulge * chord / 2; }
  [[nodiscard]] Box box() const;
  /// Where it has the height `v`, which is between those of its ends.
  [[nodiscard]] double u_at(double v) const;
};

/// `bulge` is at most that of a quarter of a circle.
[[nodiscard]] Piece piece_between(Vec2 from, Vec2 to, double bulge);
/// Of the part with the chord `chord` of what has the flexure `flexure`.
[[nodiscard]] double bulge_of_part(double flexure, double chord);

/// True when the point lies on the piece, kSame_mm beside it or behind its ends included.
[[nodiscard]] bool lies_on(const Piece& piece, Vec2 point);
/// True when the point lies on the piece, kSame_mm beside it included, and before and behind no
/// end.
[[nodiscard]] bool lies_between_ends(const Piece& piece, Vec2 point);

/// False only if the pieces are farther than kSame_mm from each other.
[[nodiscard]] bool may_meet(const Piece& a, const Piece& b);

struct Crossings {
  std::array<Vec2, 3> points{};
  std::size_t count = 0;
};
/// Points in which the curves of both pieces cross or touch and that lie on both. Curves that run
/// beside each other have none: there it is the ends that lie on the other one.
[[nodiscard]] Crossings crossings(const Piece& a, const Piece& b);

}  // namespace kerf::contour
