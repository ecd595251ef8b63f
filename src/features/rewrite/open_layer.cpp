#include "features/rewrite/open_layer.hpp"

#include <algorithm>

#include "features/rewrite/line_rows.hpp"
#include "features/rewrite/spiral_rows.hpp"
#include "features/rewrite/tool_fit.hpp"
#include "features/rewrite/wall_spiral.hpp"

namespace kerf::features {
namespace {

/// Whether all rows from the first to the last visit of a layer are its own.
bool is_in_one(const Layer& layer) {
  std::vector<Span> visits = layer.visits;
  std::sort(visits.begin(), visits.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < visits.size(); ++i) {
    if (visits[i].first > visits[i - 1].last + 1) return false;
  }
  return true;
}

/// Whether more was cut between the loops of a layer than in them.
bool is_mostly_open(const Recording& recording, const Layer& layer) {
  double balance = 0;
  for (const std::uint32_t row : layer.links) balance += recording.length_of(row);
  for (const Loop& loop : layer.loops) balance -= loop.perimeter;
  return balance > 0;
}

}  // namespace

bool is_in_lines_or_turns(const Recording& recording, const NewLayer& wanted) {
  const Feature& feature = *wanted.feature;
  switch (feature.strategy) {
    case Strategy::zig:
    case Strategy::zig_zag:
    case Strategy::spiral: return true;
    case Strategy::single:
    case Strategy::contour_parallel:
    case Strategy::adaptive: {
      const Layer& layer = feature.layers[wanted.layer];
      const bool has_many_links = layer.links.size() > 2 * layer.loops.size() + 2;
      return !bounds_what_stands(feature) &&
             (layer.visits.size() > 1 || (has_many_links && is_mostly_open(recording, layer)));
    }
    default: return false;
  }
}

tl::expected<NewRows, CannotCut> in_lines_or_turns(const Recording& recording,
                                                   const NewLayer& wanted) {
  const Layer& layer = wanted.feature->layers[wanted.layer];
  if (wanted.feature->cuts.size() != 1 || !is_in_one(layer)) {
    return cannot_edit("OTHERS CUT BETWEEN THE PASSES OF THIS LAYER: IT CAN BE MOVED OR DEEPENED");
  }
  if (layer.nominal.vertices.empty() || bounds_what_stands(*wanted.feature))
    return cannot_edit("NO WALL GOES ROUND THE PASSES OF THIS LAYER");
  const Span visit = whole_visit(recording, layer);
  const double radius = radius_of_tool(recording, wanted, visit);
  if (radius <= 0) return unknown_tool();
  const Clearing now{.region = region_between(wanted.outer, wanted.islands),
                     .tool_radius = wanted.new_radius > 0 ? wanted.new_radius : radius};
  if (auto fits = check_corners(now); !fits) return tl::unexpected(fits.error());
  if (wanted.feature->strategy == Strategy::spiral) {
    const bool is_round = layer.nominal.vertices.size() == 2;
    return is_round ? regenerated_as_spiral(recording, wanted, visit, radius)
                    : regenerated_along_walls(recording, wanted, visit, radius);
  }
  return regenerated_in_lines(recording, wanted, visit, radius);
}

}  // namespace kerf::features
