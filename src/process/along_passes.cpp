#include <fmt/format.h>

#include <cmath>

#include "process/along.hpp"
#include "process/passes.hpp"

namespace kerf::process {
namespace {

using contour::Contour;
using contour::Edge;

Pass along_pass(const Outline& outline, Contour path, StartAt start, const AlongRules& rules) {
  Along along{std::move(path), {}, {}, false};
  along.starts = starts_of(along.path, start, rules);
  return {outline.number, outline.entity, {}, std::move(along)};
}

/// A closed contour counterclockwise.
Contour upright(const Contour& path) {
  return path.is_closed && !is_counterclockwise(path) ? reversed(path) : path;
}

}  // namespace

std::optional<Circle> circle_of(const Contour& path) {
  constexpr double kSame_mm = 1e-6;
  if (!path.is_closed || path.vertices.empty()) return std::nullopt;
  const Edge first = edge_of(path, 0);
  if (first.bulge == 0) return std::nullopt;
  const Circle circle{centre(first), radius(first)};
  for (std::size_t i = 1; i < edge_count(path); ++i) {
    const Edge edge = edge_of(path, i);
    const bool goes_on = edge.bulge != 0 && (edge.bulge > 0) == (first.bulge > 0);
    if (!goes_on || std::abs(radius(edge) - circle.radius) > kSame_mm ||
        geometry::length(centre(edge) - circle.centre) > kSame_mm)
      return std::nullopt;
  }
  return circle;
}

Passes engrave_passes(const Operation& operation, const Settled& settled, const Taken& taken) {
  Passes made;
  made.rules.overcut = settled.overcut;
  for (const Outline& outline : taken.outlines)
    made.passes.push_back(along_pass(outline, upright(outline.path), operation.start, made.rules));
  return made;
}

Passes weld_passes(const Operation& operation, const Settled& /*settled*/, const Taken& taken) {
  Passes made;
  made.rules.overcut = operation.close;
  made.rules.ramp_in = operation.ramp_in;
  made.rules.ramp_out = operation.ramp_out;
  made.rules.weave = operation.weave;
  for (const Outline& outline : taken.outlines)
    made.passes.push_back(along_pass(outline, upright(outline.path), operation.start, made.rules));
  return made;
}

Passes drill_passes(const Operation& operation, const Taken& taken) {
  Passes made;
  for (const drawing::Point& point : taken.points)
    made.passes.push_back({kNoContour, point.entity, {}, Spot{point.at}});
  for (const Outline& outline : taken.outlines) {
    const std::optional<Circle> circle = circle_of(outline.path);
    if (circle && 2 * circle->radius <= operation.max_diameter + 1e-9) {
      made.passes.push_back({outline.number, outline.entity, {}, Spot{circle->centre}});
    } else {
      made.remarks.push_back(
          {base::Code::job_value, false, outline.entity,
           circle
               ? fmt::format(
                     "a circle of {:.6g} mm is wider than max_diameter {:.6g}; it is not drilled",
                     2 * circle->radius, operation.max_diameter)
               : "a contour that is no circle has no centre to drill; it is left out"});
    }
  }
  return made;
}

}  // namespace kerf::process
