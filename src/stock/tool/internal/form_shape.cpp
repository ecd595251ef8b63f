#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/decimal.hpp"
#include "geometry/contour/edge.hpp"
#include "stock/tool/internal/angles.hpp"
#include "stock/tool/internal/cutting_shape.hpp"
#include "stock/tool/internal/outline.hpp"

namespace kerf::stock {
namespace {

using contour::Edge;

std::string place(std::size_t index) { return "point " + std::to_string(index) + " of profile"; }

std::string objection_to_points(const std::vector<FormPoint>& points) {
  if (points.size() < 2) return "a form tool needs a profile of two points or more";
  if (points.front().z != 0) return "profile begins at height 0, the tip";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].r < 0) return place(i) + " is beyond the axis";
    if (i > 0 && points[i].z < points[i - 1].z) return place(i) + " is below the one before";
  }
  return {};
}

/// The ends of an arc are not enough: it may bulge over the axis, or go down on its way.
std::string objection_to_edge(const Edge& edge, std::size_t index) {
  if (edge.bulge == 0) return {};
  if (std::abs(edge.bulge) > 1) return place(index) + " begins an arc of more than half a circle";
  const contour::Box box = contour::extents(edge);
  if (box.low.u < -kAlmost_mm) return place(index) + " begins an arc that crosses the axis";
  if (box.low.v < edge.from.v - kAlmost_mm || box.high.v > edge.to.v + kAlmost_mm)
    return place(index) + " begins an arc that does not rise throughout";
  return {};
}

ToolPart part_of(std::size_t i, const std::optional<FormCutting>& cutting, double r,
                 double widest) {
  const bool cuts = !cutting || (i >= cutting->from && i < cutting->to);
  if (cuts) return ToolPart::edge;
  return r <= widest ? ToolPart::flank : ToolPart::shank;
}

void draw(Outline& outline, const Edge& edge, ToolPart part) {
  const ProfilePoint to{edge.to.u, edge.to.v};
  if (edge.bulge == 0) return outline.to(to, part);
  const contour::Vec2 centre = contour::centre(edge);
  outline.arc_to(to, {centre.u, centre.v}, contour::sweep_rad(edge), part);
}

}  // namespace

ShapeOutcome form_shape(const Tool& tool) {
  const std::vector<FormPoint>& points = tool.form;
  if (std::string wrong = objection_to_points(points); !wrong.empty()) return tl::unexpected(wrong);
  const auto& cutting = tool.cutting;
  if (cutting && (cutting->from >= cutting->to || cutting->to >= points.size()))
    return tl::unexpected(std::string("cutting is two points of profile, counted from 0"));
  Outline outline;
  outline.out_to(points.front().r, part_of(0, cutting, 0, 0));
  double widest = points.front().r;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Edge edge{
        {points[i].r, points[i].z}, {points[i + 1].r, points[i + 1].z}, points[i].bulge};
    if (std::string wrong = objection_to_edge(edge, i); !wrong.empty())
      return tl::unexpected(wrong);
    const double farthest = contour::extents(edge).high.u;
    const ToolPart part = part_of(i, cutting, farthest, widest + kAlmost_mm);
    draw(outline, edge, part);
    if (part == ToolPart::edge) widest = std::max(widest, farthest);
  }
  return CuttingShape{.edges = outline.take(), .ends = true, .neck_mm = points.back().r};
}

}  // namespace kerf::stock
