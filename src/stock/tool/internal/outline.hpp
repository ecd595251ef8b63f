#pragma once

#include <utility>
#include <vector>

#include "stock/tool/profile.hpp"

namespace kerf::stock {

/// Draws the outline of a body of revolution upwards from the tip. Edges of no length are left out.
class Outline {
 public:
  Outline() = default;
  /// Goes on where these end.
  explicit Outline(std::vector<ProfileEdge> edges) : edges_(std::move(edges)) {}

  [[nodiscard]] ProfilePoint at() const {
    return edges_.empty() ? ProfilePoint{} : edges_.back().to;
  }
  /// A line, or an arc by its bulge.
  void to(ProfilePoint point, ToolPart part, double bulge = 0);
  void out_to(double r, ToolPart part) { to({r, at().z}, part); }
  void up_to(double z, ToolPart part) { to({at().r, z}, part); }
  /// An arc about `centre` that turns by `sweep_rad`, positive counterclockwise; at most half a
  /// circle, in pieces of at most a quarter, the last of which ends in `point`.
  void arc_to(ProfilePoint point, ProfilePoint centre, double sweep_rad, ToolPart part);

  [[nodiscard]] const std::vector<ProfileEdge>& edges() const { return edges_; }
  [[nodiscard]] std::vector<ProfileEdge> take() { return std::move(edges_); }

 private:
  std::vector<ProfileEdge> edges_;
};

}  // namespace kerf::stock
