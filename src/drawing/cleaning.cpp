#include "drawing/cleaning.hpp"

#include <utility>

#include "drawing/internal/duplicates.hpp"
#include "drawing/internal/joining.hpp"

namespace kerf::drawing {
namespace {

bool is_shorter(const contour::Contour& path, double least_mm) {
  double sum = 0;
  for (std::size_t i = 0; i < edge_count(path); ++i) {
    sum += length(edge_of(path, i));
    if (sum >= least_mm) return false;
  }
  return true;
}

/// Edges of next to no length have a direction by rounding alone, and no machine makes them.
void drop_empty_edges(contour::Contour& path) {
  constexpr double kNothing_mm = 1e-6;
  std::vector<contour::Vertex> kept;
  for (const contour::Vertex& vertex : path.vertices) {
    if (!kept.empty() && geometry::length(vertex.point - kept.back().point) <= kNothing_mm) {
      kept.back().bulge = vertex.bulge;
      continue;
    }
    kept.push_back(vertex);
  }
  const bool meets_itself = path.is_closed && kept.size() > 1 &&
                            geometry::length(kept.front().point - kept.back().point) <= kNothing_mm;
  if (meets_itself) kept.pop_back();
  path.vertices = std::move(kept);
}

}  // namespace

Cleaned clean(const Drawing& drawing, const CleaningRules& rules, Canvas& canvas) {
  Cleaned cleaned;
  cleaned.points = drawing.points;
  std::vector<Chain> chains;
  chains.reserve(drawing.paths.size());
  for (const Path& path : drawing.paths) {
    Chain chain{contour_of(drawing, path), drawing.vertices[path.first].owner};
    if (path.count == 1) {
      cleaned.points.push_back({chain.path.vertices[0].point, chain.entity});
    } else if (is_shorter(chain.path, rules.same_mm)) {
      ++cleaned.zero_length;
    } else {
      drop_empty_edges(chain.path);
      chains.push_back(std::move(chain));
    }
  }
  const std::size_t before = chains.size();
  chains = without_duplicates(std::move(chains), drawing, rules.same_mm);
  cleaned.duplicates = before - chains.size();
  Joined joined = join_ends(std::move(chains), drawing, rules.join_mm, canvas);
  cleaned.chains = std::move(joined.chains);
  cleaned.joined = joined.joined;
  cleaned.gaps = joined.gaps;
  return cleaned;
}

}  // namespace kerf::drawing
