#include "features/turning/reach.hpp"

#include <algorithm>
#include <array>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;
using contour::Region;
using contour::Vec2;

constexpr double kFar_mm = 1e4;  // beyond all bars
constexpr double kNoWidth_mm = 1e-9;

/// A point on the far side, straight beyond another one.
Vec2 far_from(Vec2 at, Beyond beyond) {
  switch (beyond) {
    case Beyond::outside: return {at.u, kFar_mm};
    case Beyond::inside: return {at.u, -1};
    case Beyond::front: return {kFar_mm, at.v};
  }
  return at;
}

Vec2 across(Beyond beyond, double by) {
  return beyond == Beyond::front ? Vec2{0, by} : Vec2{by, 0};
}

Contour strip(const Edge& edge, Beyond beyond) {
  return {{{edge.from, edge.bulge, edge.owner},
           {edge.to, 0, edge.owner},
           {far_from(edge.to, beyond), 0, edge.owner},
           {far_from(edge.from, beyond), 0, edge.owner}},
          true};
}

Edge shifted(Edge edge, Vec2 by) {
  edge.from = edge.from + by;
  edge.to = edge.to + by;
  return edge;
}

/// The point of an edge that lies farthest from the far side.
Vec2 deepest(const Edge& edge, Beyond beyond) {
  const contour::Box box = contour::extents(edge);
  const auto depth = [&](Vec2 at) {
    if (beyond == Beyond::front) return -at.u;
    return beyond == Beyond::outside ? -at.v : at.v;
  };
  Vec2 best = depth(edge.from) >= depth(edge.to) ? edge.from : edge.to;
  if (edge.bulge == 0) return best;
  const Vec2 centre = contour::centre(edge);
  const Vec2 low{centre.u, box.low.v};
  const Vec2 high{centre.u, box.high.v};
  const Vec2 left{box.low.u, centre.v};
  for (const Vec2 at : {low, high, left}) {
    if (contour::distance(edge, at) < 1e-6 && depth(at) > depth(best)) best = at;
  }
  return best;
}

// From the imaginary tip to the centre of the nose along Z and X, in radii, by its direction.
constexpr std::array<Vec2, 10> kCentres = {
    {{0, 0}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}, {0, 0}}};

}  // namespace

Nose nose_of(const stock::Tool& tool) {
  const double radius = tool.said(stock::Measure::nose_radius).value_or(0);
  const auto tip = tool.said(stock::Measure::tip);
  if (radius <= 0 || !tip || *tip < 0 || *tip >= static_cast<double>(kCentres.size())) return {};
  return {radius, radius * kCentres[static_cast<std::size_t>(*tip)]};
}

Region reached_by_nose(const std::vector<Edge>& path, Beyond beyond, const Nose& nose) {
  std::vector<Edge> middle;
  Contour way{{}, false};
  for (const Edge& edge : path) {
    middle.push_back(shifted(edge, nose.centre));
    way.vertices.push_back({middle.back().from, edge.bulge, edge.owner});
  }
  if (!middle.empty()) way.vertices.push_back({middle.back().to, 0, middle.back().owner});
  return contour::unite(reached(middle, beyond, {}), contour::sweep_of_disc(way, nose.radius));
}

TipWidth tip_width(const stock::Tool& tool) {
  const double width = tool.value(stock::Measure::width).value_or(0);
  const auto tip = static_cast<int>(tool.value(stock::Measure::tip).value_or(3));
  if (tool.kind == stock::ToolKind::face_grooving) {
    // Tips 1, 2, 6 stand with their far corner from the axis on the programmed point.
    if (tip == 1 || tip == 2 || tip == 6) return {-width, 0};
    return tip == 5 || tip == 7 || tip == 0 || tip == 9 ? TipWidth{-width / 2, width / 2}
                                                        : TipWidth{0, width};
  }
  if (tip == 1 || tip == 4 || tip == 5) return {-width, 0};
  return tip == 6 || tip == 8 || tip == 0 || tip == 9 ? TipWidth{-width / 2, width / 2}
                                                      : TipWidth{0, width};
}

Region reached(const std::vector<Edge>& path, Beyond beyond, TipWidth width) {
  std::vector<Contour> strips;
  const bool is_wide = width.high - width.low > kNoWidth_mm;
  for (const Edge& edge : path) {
    strips.push_back(strip(shifted(edge, across(beyond, width.low)), beyond));
    if (!is_wide) continue;
    strips.push_back(strip(shifted(edge, across(beyond, width.high)), beyond));
    const Vec2 low = deepest(edge, beyond);
    strips.push_back(
        strip({low + across(beyond, width.low), low + across(beyond, width.high), 0, edge.owner},
              beyond));
  }
  return contour::region_of(strips);
}

}  // namespace kerf::features
