#include "stock/tool/profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

[[maybe_unused]] bool is_sound(std::span<const ProfileEdge> edges) {
  if (edges.empty()) return true;
  if (edges.front().from != ProfilePoint{}) return false;
  const auto rises = [](const ProfileEdge& edge) {
    return edge.to.z >= edge.from.z && edge.from.r >= 0 && edge.to.r >= 0;
  };
  const auto follows = [](const ProfileEdge& a, const ProfileEdge& b) { return a.to == b.from; };
  return std::all_of(edges.begin(), edges.end(), rises) &&
         std::adjacent_find(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
           return !follows(a, b);
         }) == edges.end();
}

double widest_of(const ProfileEdge& edge) { return std::max(edge.from.r, edge.to.r); }

/// Radius of a rising edge at a height between its ends.
double radius_on(const ProfileEdge& edge, double z) {
  const double dr = edge.to.r - edge.from.r;
  const double dz = edge.to.z - edge.from.z;
  if (edge.bulge == 0) return edge.from.r + dr * (z - edge.from.z) / dz;
  // The centre is on the perpendicular through the middle of the chord.
  const double reach = (1 - edge.bulge * edge.bulge) / (4 * edge.bulge);
  const ProfilePoint centre{(edge.from.r + edge.to.r) / 2 - dz * reach,
                            (edge.from.z + edge.to.z) / 2 + dr * reach};
  const double squared = (edge.from.r - centre.r) * (edge.from.r - centre.r) +
                         (edge.from.z - centre.z) * (edge.from.z - centre.z);
  const double across = std::sqrt(std::max(0.0, squared - (z - centre.z) * (z - centre.z)));
  // Counterclockwise arcs that rise have their centre on the side of the axis.
  return std::max(0.0, edge.bulge > 0 ? centre.r + across : centre.r - across);
}

}  // namespace

Profile::Profile(std::vector<ProfileEdge> edges) : edges_(std::move(edges)) {
  assert(is_sound(edges_));
}

double Profile::widest(ToolPart part) const {
  double most = 0;
  for (const ProfileEdge& edge : edges_) {
    if (edge.part == part) most = std::max(most, widest_of(edge));
  }
  return most;
}

double Profile::widest() const {
  double most = 0;
  for (const ProfileEdge& edge : edges_) most = std::max(most, widest_of(edge));
  return most;
}

double Profile::edge_height() const {
  double top = 0;
  for (const ProfileEdge& edge : edges_) {
    if (edge.part == ToolPart::edge) top = edge.to.z;
  }
  return top;
}

double Profile::height() const { return edges_.empty() ? 0 : edges_.back().to.z; }

bool Profile::has_undercut() const {
  return std::any_of(edges_.begin(), edges_.end(), [](const ProfileEdge& edge) {
    return edge.part == ToolPart::edge && edge.to.r < edge.from.r;
  });
}

double Profile::radius_at(double z) const {
  double most = 0;
  for (const ProfileEdge& edge : edges_) {
    if (z < edge.from.z || z > edge.to.z) continue;
    most = std::max(most, edge.from.z == edge.to.z ? widest_of(edge) : radius_on(edge, z));
  }
  return most;
}

}  // namespace kerf::stock
