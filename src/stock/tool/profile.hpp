#pragma once

#include <span>
#include <vector>

#include "stock/tool/tool_part.hpp"

namespace kerf::stock {

/// A point of the half plane through the axis of a tool, mm: distance from the axis, height above
/// the tip.
struct ProfilePoint {
  double r = 0;
  double z = 0;

  friend constexpr bool operator==(ProfilePoint, ProfilePoint) = default;
};

/// A piece of a tool's outline from below to above: a line, or an arc of at most a quarter circle.
/// `bulge` is the tangent of a quarter of the angle that the arc sweeps in the plane (r, z),
/// positive counterclockwise: the lower quarter of a ball from (0, 0) to (R, R) has tan(π/8).
struct ProfileEdge {
  ProfilePoint from;
  ProfilePoint to;
  double bulge = 0;
  ToolPart part = ToolPart::edge;

  friend constexpr bool operator==(const ProfileEdge&, const ProfileEdge&) = default;
};

/// A tool as a body of revolution: its outline from the tip on the axis upwards. Each edge begins
/// where the one before ends; heights never fall, r >= 0, arcs rise everywhere. A level edge is a
/// face (that of an end mill, the shoulder of a holder). What is between the outline and the axis
/// is the tool; a flat edge belongs to the body above it where it leads outwards, below it where
/// inwards. Immutable.
class Profile {
 public:
  /// A body that nobody has said the top of goes up to here.
  static constexpr double kEndless_mm = 1e6;

  Profile() = default;
  /// Precondition: the edges are as the class says.
  explicit Profile(std::vector<ProfileEdge> edges);

  [[nodiscard]] std::span<const ProfileEdge> edges() const { return edges_; }
  [[nodiscard]] bool is_empty() const { return edges_.empty(); }
  /// Largest r of the edges of this part; 0: it has none.
  [[nodiscard]] double widest(ToolPart part) const;
  [[nodiscard]] double widest() const;
  /// Where the cutting part ends.
  [[nodiscard]] double edge_height() const;
  [[nodiscard]] double height() const;
  /// The outline never comes back inwards as far as it cuts: seen from above it hides nothing.
  [[nodiscard]] bool has_undercut() const;
  /// Largest r at this height; where a level edge lies, the largest of it.
  [[nodiscard]] double radius_at(double z) const;

 private:
  std::vector<ProfileEdge> edges_;
};

}  // namespace kerf::stock
