#include "features/milling/shaped_level.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "features/milling/entry.hpp"
#include "features/milling/layer_rows.hpp"
#include "features/milling/long_sweep.hpp"
#include "features/milling/nominal.hpp"
#include "features/milling/path_corners.hpp"
#include "features/milling/smooth_wall.hpp"
#include "features/milling/wall_passes.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kSameRadius_mm = 1e-4;
constexpr double kOnBorder_mm = 1e-4;

Region filled(const Contour& loop) {
  return {{contour::is_counterclockwise(loop) ? loop : contour::reversed(loop)}};
}

/// The longest of the loops that go counterclockwise; null: there is none.
const Contour* outline_of(const Region& region) {
  const Contour* outline = nullptr;
  double most = 0;
  for (const Contour& loop : region.loops) {
    const double area = contour::area(loop);
    if (area > most) outline = &loop;
    most = std::max(most, area);
  }
  return outline;
}

/// A loop of what was removed as it is told.
Contour told(const Recording& recording, WallPasses& passes, const Contour& loop) {
  const Contour wall = passes.cleaned(loop).value_or(loop);
  return normal_form(without_slivers(smooth_wall(recording, wall), kSamePoint_mm));
}

// What stands in a hole of the region. Where all of it has gone before there is no island.
void add_islands(const Recording& recording, const Material& material, const Contour& hole,
                 WallPasses& passes, Layer& layer) {
  const Region inside = filled(hole);
  const Region left = material.standing(inside, layer.z);
  if (contour::area(left) <= kEmptyArea_mm2) return;
  for (const Contour& loop : left.loops) {
    if (contour::is_counterclockwise(loop) && !is_sliver(loop))
      layer.islands.push_back(told(recording, passes, loop));
  }
}

double radius_of_owner(const Recording& recording, std::uint32_t owner) {
  if (owner >= recording.count()) return 0;
  const auto tool = recording.tools.find(recording.state_of(recording.moves[owner]).tool);
  return tool == recording.tools.end() ? 0 : reach_of(tool->second).radius;
}

/// Tells rounded corners from arcs that are meant; the path is looked at when the first one is met.
IsToolCorner tool_corners(const Recording& recording, double radius, const Layer& layer) {
  auto corners = std::make_shared<std::unique_ptr<PathCorners>>();
  return [&recording, &layer, radius, corners](const Edge& arc) {
    const double r = contour::radius(arc);
    const bool is_tools = std::fabs(r - radius) < kSameRadius_mm ||
                          std::fabs(r - radius_of_owner(recording, arc.owner)) < kSameRadius_mm;
    if (!is_tools) return false;
    if (!*corners)
      *corners = std::make_unique<PathCorners>(recording, rows_across(recording, layer));
    return (*corners)->is_corner(contour::centre(arc));
  };
}

void tell_nominal(const Recording& recording, double radius, Layer& layer) {
  const IsToolCorner is_tool_corner = tool_corners(recording, radius, layer);
  layer.nominal = sharpened(layer.contour, false, is_tool_corner);
  layer.nominal_islands.clear();
  for (const Contour& island : layer.islands)
    layer.nominal_islands.push_back(sharpened(island, true, is_tool_corner));
}

bool is_open(const Region& border, const Edge& edge) {
  for (const double share : {0.02, 0.5, 0.98}) {
    if (contour::distance_to_border(border, contour::point_at(edge, share)) > kOnBorder_mm)
      return false;
  }
  return true;
}

// How much of the outline is the border of the blank.
void tell_openness(const Material& material, ShapedLevel& shaped) {
  const Contour& outline = shaped.layer.contour;
  shaped.outline_mm = contour::length(outline);
  const std::size_t count = contour::edge_count(outline);
  if (!material.blank().is_known || count == 0) return;
  std::vector<bool> open(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Edge edge = contour::edge_of(outline, i);
    open[i] = is_open(material.blank().outline, edge);
    if (open[i]) shaped.open_mm += contour::length(edge);
  }
  for (std::size_t i = 0; i < count; ++i)
    shaped.wall_chains += static_cast<int>(!open[i] && open[(i + count - 1) % count]);
}

// A cone is as wide as what it meets is high.
bool fit_cone(const Recording& recording, const Material& material, const ToolReach& reach,
              Level& level, Allowance& allowance) {
  const double top = material.top_over(level.sweep, level.z);
  const double radius = reach.at_depth(top - level.z);
  if (std::fabs(radius - level.radius) < kSameRadius_mm || radius <= 0) return true;
  level.radius = radius;
  std::vector<Contour> paths;
  for (const LevelRun& run : level.runs) paths.push_back(path_of(recording, run));
  auto sweep = swept_along(paths, radius, allowance);
  if (sweep) level.sweep = std::move(*sweep);
  return sweep.has_value();
}

void tell_rows(const Recording& recording, ShapedLevel& shaped) {
  Layer& layer = shaped.layer;
  layer.z = shaped.level.z;
  for (const LevelRun& run : shaped.level.runs) {
    layer.cuts.push_back(run.rows);
    layer.entries.insert(layer.entries.end(), run.entries.begin(), run.entries.end());
    layer.visits.push_back(run.visit);
  }
  layer.frame = recording.state_of(recording.moves[layer.cuts.front().first]).frame;
  layer.loops = shaped.loops.loops;
  layer.links = shaped.loops.links;
}

bool are_same(const std::vector<Contour>& a, const std::vector<Contour>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contour& p, const Contour& q) {
    return are_equal(p, q, kSamePoint_mm);
  });
}

}  // namespace

bool are_one_shape(const Layer& a, const Layer& b) {
  return are_equal(a.nominal, b.nominal, kSamePoint_mm) &&
         are_same(a.nominal_islands, b.nominal_islands);
}

std::size_t outline_count(const Region& region) {
  return static_cast<std::size_t>(std::count_if(
      region.loops.begin(), region.loops.end(),
      [](const Contour& loop) { return contour::is_counterclockwise(loop) && !is_sliver(loop); }));
}

void tell_contours(const Recording& recording, const Material& material, double radius,
                   Layer& layer) {
  layer.contour = {};
  layer.islands.clear();
  const Contour* const outline = outline_of(layer.removed);
  if (outline == nullptr) return;
  WallPasses passes(recording, layer);
  layer.contour = told(recording, passes, *outline);
  for (const Contour& loop : layer.removed.loops) {
    if (!contour::is_counterclockwise(loop)) add_islands(recording, material, loop, passes, layer);
  }
  tell_nominal(recording, radius, layer);
}

std::optional<ShapedLevel> shaped(const Recording& recording, const Material& material,
                                  const ToolReach& reach, Level&& level, Allowance& allowance) {
  if (reach.is_cone() && !fit_cone(recording, material, reach, level, allowance))
    return std::nullopt;
  ShapedLevel shaped{.level = std::move(level)};
  const Level& its = shaped.level;
  shaped.loops = loops_of(recording, its.rows(recording));
  shaped.ring = ring_of(recording, its, shaped.loops);
  tell_rows(recording, shaped);
  Layer& layer = shaped.layer;
  const Region& sweep = shaped.ring ? shaped.ring->sweep : its.sweep;
  layer.removed = material.standing(sweep, its.z);
  layer.area = contour::area(layer.removed);
  layer.top = material.top_over(layer.removed.is_empty() ? sweep : layer.removed, its.z);
  const bool is_in_pieces = outline_count(layer.removed) > 1;
  Layer whole = layer;
  if (is_in_pieces) whole.removed = sweep;
  tell_contours(recording, material, its.radius, whole);
  whole.removed = layer.removed;
  layer = std::move(whole);
  tell_openness(material, shaped);
  layer.entry = entry_of(recording, shaped);
  return shaped;
}

}  // namespace kerf::features
