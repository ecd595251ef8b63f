#include "features/literal/relations.hpp"

#include <algorithm>

namespace kerf::features {
namespace {

using contour::Contour;

constexpr std::size_t kMostFeatures = 64;

Contour outer_path(const Recording& recording, const LiteralTree& literal,
                   const LiteralFeature& feature) {
  const auto& loops = literal.layers[feature.layers.front()].loops;
  const auto longest =
      std::max_element(loops.begin(), loops.end(),
                       [](const Loop& a, const Loop& b) { return a.perimeter < b.perimeter; });
  return longest == loops.end() ? Contour{} : recording.contour_of(longest->rows);
}

}  // namespace

// From both sides, because of what contains another one the other side sees nothing.
std::vector<LiteralRelation> relations_of(const Recording& recording, const LiteralTree& literal) {
  const std::size_t count = std::min(literal.features.size(), kMostFeatures);
  std::vector<Contour> paths;
  for (std::size_t i = 0; i < count; ++i)
    paths.push_back(outer_path(recording, literal, literal.features[i]));
  std::vector<LiteralRelation> relations;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      const ScanRelation there = scan_relation(paths[i], paths[k]);
      const ScanRelation back = scan_relation(paths[k], paths[i]);
      if (there == ScanRelation::contains) {
        relations.push_back({i, k, there});
      } else if (back == ScanRelation::contains) {
        relations.push_back({k, i, back});
      } else if (there == ScanRelation::partial || back == ScanRelation::partial) {
        relations.push_back({i, k, ScanRelation::partial});
      }
    }
  }
  return relations;
}

}  // namespace kerf::features
