#include "features/turning/shape.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/tree/corner.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kLongestChamfer_mm = 5;
constexpr double kSameRadius_mm = 1e-4;
constexpr double kHalfRight_deg = 45;
constexpr double kOffHalfRight_deg = 1;

double length_of(const Contour& contour) {
  double sum = 0;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
    sum += contour::length(contour::edge_of(contour, i));
  return sum;
}

/// The runs of edges of a loop that hold, each an open contour.
std::vector<Contour> runs_of(const Contour& loop, const std::function<bool(std::uint32_t)>& own) {
  const std::size_t count = contour::edge_count(loop);
  std::vector<Contour> runs;
  std::size_t first = 0;
  while (first < count && own(loop.vertices[first].owner)) ++first;
  if (first == count) first = 0;  // all of it: it begins anywhere
  bool goes_on = false;
  for (std::size_t k = 0; k < count; ++k) {
    const Edge edge = contour::edge_of(loop, (first + k) % count);
    const bool is_own = own(edge.owner);
    if (is_own && !goes_on) runs.push_back({{{edge.from, edge.bulge, edge.owner}}, false});
    if (is_own) {
      runs.back().vertices.back().bulge = edge.bulge;
      runs.back().vertices.back().owner = edge.owner;
      runs.back().vertices.push_back({edge.to, 0, edge.owner});
    }
    goes_on = is_own;
  }
  return runs;
}

double angle_to_axis_deg(const Edge& edge) {
  const double z = std::fabs(edge.to.u - edge.from.u);
  const double r = std::fabs(edge.to.v - edge.from.v);
  return geometry::degrees(math::atan2(r, z));
}

bool is_chamfer(const Edge& edge) {
  return std::fabs(angle_to_axis_deg(edge) - kHalfRight_deg) <= kOffHalfRight_deg &&
         std::fabs(edge.to.u - edge.from.u) <= kLongestChamfer_mm + kSamePoint_mm;
}

TurnedElement element_of(const Edge& edge) {
  TurnedElement element{.z = edge.to.u, .x = 2 * edge.to.v, .rows = {edge.owner, edge.owner}};
  using Kind = TurnedElement::Kind;
  if (edge.bulge != 0) {
    element.kind = Kind::radius;
    element.radius = contour::radius(edge);
  } else if (std::fabs(edge.to.v - edge.from.v) <= kSamePoint_mm) {
    element.kind = Kind::cylinder;
  } else if (std::fabs(edge.to.u - edge.from.u) <= kSamePoint_mm) {
    element.kind = Kind::shoulder;
  } else {
    element.kind = is_chamfer(edge) ? Kind::chamfer : Kind::taper;
    element.angle_deg = angle_to_axis_deg(edge);
  }
  return element;
}

}  // namespace

Contour left_contour(const contour::Region& removed, const std::function<bool(std::uint32_t)>& own,
                     contour::Vec2 begin) {
  Contour longest{{}, false};
  double most = 0;
  for (const Contour& loop : removed.loops) {
    for (const Contour& run : runs_of(loop, own)) {
      const double length = length_of(run);
      if (length > most) longest = run;
      most = std::max(most, length);
    }
  }
  if (longest.vertices.empty()) return longest;
  const double to_front = geometry::length(longest.vertices.front().point - begin);
  const double to_back = geometry::length(longest.vertices.back().point - begin);
  if (to_back < to_front) longest = contour::reversed(longest);
  return normal_form(longest);
}

Contour without_nose(const Contour& contour, double radius) {
  if (radius <= 0 || contour::edge_count(contour) < 3) return contour;
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
    edges.push_back(contour::edge_of(contour, i));
  for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
    const bool is_nose =
        edges[i].bulge != 0 && std::fabs(contour::radius(edges[i]) - radius) < kSameRadius_mm;
    const auto corner = is_nose ? corner_of(edges[i - 1], edges[i], edges[i + 1]) : std::nullopt;
    if (!corner) continue;
    edges[i - 1].to = *corner;
    edges[i + 1].from = *corner;
    edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
  }
  Contour sharp{{}, false};
  for (const Edge& edge : edges) sharp.vertices.push_back({edge.from, edge.bulge, edge.owner});
  sharp.vertices.push_back({edges.back().to, 0, edges.back().owner});
  return normal_form(sharp);
}

std::vector<TurnedElement> elements_of(const Contour& contour) {
  std::vector<TurnedElement> elements;
  for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
    elements.push_back(element_of(contour::edge_of(contour, i)));
  return elements;
}

}  // namespace kerf::features
