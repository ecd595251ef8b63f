#include "features/milling/chamfer.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kBeside_mm = 0.05;  // by which the path may leave its distance
constexpr double kLeastShare = 0.6;  // of its length, that runs beside the edge
constexpr std::size_t kMostSamples = 400;

/// Points in the middles of the rows, and how long these are.
struct Sample {
  Vec2 at;
  double length = 0;
};

std::vector<Sample> samples_of(const Neighbourhood& around, const Draft& draft) {
  std::vector<Edge> edges;
  for (const std::uint32_t row : draft.first.level.rows(around.recording))
    around.recording.append_edges(row, edges);
  const std::size_t step = std::max<std::size_t>(1, edges.size() / kMostSamples);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < edges.size(); i += step)
    samples.push_back({contour::point_at(edges[i], 0.5), contour::length(edges[i])});
  return samples;
}

double distance_to_edges(const Layer& layer, Vec2 at) {
  double least = contour::distance(layer.contour, at);
  for (const Contour& island : layer.islands)
    least = std::min(least, contour::distance(island, at));
  return least;
}

/// The distance at which most of the samples lie, by length; none: they lie at many.
std::optional<double> common_distance(const Layer& layer, const std::vector<Sample>& samples) {
  std::vector<std::pair<double, double>> distances;
  double all = 0;
  for (const Sample& sample : samples) {
    distances.emplace_back(distance_to_edges(layer, sample.at), sample.length);
    all += sample.length;
  }
  std::sort(distances.begin(), distances.end());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    double beside = 0;
    for (std::size_t k = i; k < distances.size(); ++k) {
      if (distances[k].first - distances[i].first <= kBeside_mm) beside += distances[k].second;
    }
    if (beside >= kLeastShare * all) return distances[i].first;
  }
  return std::nullopt;
}

}  // namespace

bool take_chamfer(const Neighbourhood& around, Draft& draft) {
  const std::vector<Sample> samples = samples_of(around, draft);
  const double radius = draft.first.level.radius;
  const contour::Box box =
      contour::extents(path_of(around.recording, draft.first.level.runs.front()));
  for (std::size_t i = around.place; i-- > 0;) {
    const Draft& edge = around.drafts[i];
    if (edge.is_gone || edge.feature.setup != draft.feature.setup) continue;
    if (!has_levels(edge.feature.type) || edge.feature.layers.empty()) continue;
    const Layer& layer = edge.feature.layers.front();
    if (layer.contour.vertices.empty()) continue;
    if (!contour::extents(layer.contour).grown(radius).meets(box)) continue;
    const auto distance = common_distance(layer, samples);
    if (!distance || *distance >= radius - kSamePoint_mm) continue;
    const auto beside = std::find_if(samples.begin(), samples.end(), [&](const Sample& sample) {
      return std::fabs(distance_to_edges(layer, sample.at) - *distance) <= kBeside_mm;
    });
    const bool is_in_cut = contour::side_of(layer.removed, beside->at, 0) != contour::Side::outside;
    const double width = is_in_cut ? radius - *distance : radius + *distance;
    draft.feature.parent = Relation{i, RelationKind::edge};
    draft.feature.measures.width = width;
    return true;
  }
  return false;
}

}  // namespace kerf::features
