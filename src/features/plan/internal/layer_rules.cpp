#include "features/plan/internal/layer_rules.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/rewrite/clearing.hpp"
#include "features/rewrite/regenerate.hpp"
#include "features/tree/normal_form.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {
namespace {

using base::Code;
using contour::Contour;
using contour::Region;
using contour::Vec2;

Region region_of(const LayerContours& contours) {
  return region_between(contours.outer, contours.islands);
}

/// Its contours, if it hangs together.
std::optional<LayerContours> contours_of(const Region& region) {
  LayerContours contours;
  int outer = 0;
  for (const Contour& loop : region.loops) {
    const bool is_outer = contour::is_counterclockwise(loop);
    outer += static_cast<int>(is_outer);
    (is_outer ? contours.outer : contours.islands.emplace_back()) = normal_form(loop);
  }
  return outer == 1 ? std::optional(contours) : std::nullopt;
}

bool is_same(const Region& a, const Region& b) {
  const Region other = contour::symmetric_difference(a, b);
  return contour::area(contour::offset(other, -kSamePoint_mm / 2)) <= kEmptyArea_mm2;
}

Region shifted(Region region, Vec2 by) {
  for (Contour& loop : region.loops) loop = moved(std::move(loop), by);
  return region;
}

}  // namespace

LayerContours contours_of(const Layer& layer) {
  return {.outer = layer.nominal, .islands = layer.nominal_islands};
}

Contour moved(Contour contour, Vec2 by) {
  for (contour::Vertex& vertex : contour.vertices) vertex.point = vertex.point + by;
  return contour;
}

LayerContours moved(LayerContours contours, Vec2 by) {
  contours.outer = moved(std::move(contours.outer), by);
  for (Contour& island : contours.islands) island = moved(std::move(island), by);
  return contours;
}

LayerRules::LayerRules(EditScene& scene, std::size_t feature)
    : scene_(scene), feature_(feature), its_(scene.tree.features[feature]) {
  for (const Layer& layer : its_.layers) {
    contours_.push_back(features::contours_of(layer));
    before_.push_back(region_of(contours_.back()));
  }
  regions_ = before_;
  is_other_.resize(its_.layers.size(), false);
}

Done LayerRules::follow(FeatureWish& wish) {
  if (wish.rules.empty()) return {};
  for (const auto& [layer, rule] : wish.rules) {
    const Vec2 by{wish.by.x, wish.by.y};
    if (auto done = finish(layer, wish.layers.at(layer), by); !done) return done;
  }
  for (const auto& [layer, rule] : wish.rules) follow_layer(layer, wish);
  if (auto done = check_undercut(); !done) return done;
  for (std::size_t layer = 0; layer < regions_.size(); ++layer) {
    if (auto done = settle(layer); !done) return done;
  }
  return {};
}

Done LayerRules::finish(std::size_t layer, const ContourEdit& edit, Vec2 by) {
  auto finished = edit.finished();
  if (!finished) return scene_.refuse(finished.error());
  regions_[layer] = region_of(moved(std::move(*finished), Vec2{} - by));
  return {};
}

// The layers that are not named follow, by what is removed.
void LayerRules::follow_layer(std::size_t edited, const FeatureWish& wish) {
  const Region& wanted = regions_[edited];
  const LayerRule rule = wish.rules.at(edited);
  const bool stands = bounds_what_stands(its_);
  for (std::size_t other = 0; other < regions_.size(); ++other) {
    if (wish.rules.count(other) > 0) continue;
    if (rule == LayerRule::all) regions_[other] = wanted;
    if (rule != LayerRule::rebuild) continue;
    const bool grows = (other < edited) != stands;
    const Region followed = grows ? contour::unite(regions_[other], wanted)
                                  : contour::intersect(regions_[other], wanted);
    if (!is_same(followed, regions_[other]))
      regions_[other] = is_same(followed, wanted) ? wanted : followed;
  }
}

// No tool cuts below what stands: each layer must hold the one below it.
Done LayerRules::check_undercut() const {
  const bool stands = bounds_what_stands(its_);
  for (std::size_t layer = 1; layer < regions_.size(); ++layer) {
    const Region& upper = regions_[stands ? layer : layer - 1];
    const Region& lower = regions_[stands ? layer - 1 : layer];
    const Region under = contour::offset(contour::subtract(lower, upper), -kSamePoint_mm);
    if (contour::area(under) <= kEmptyArea_mm2) continue;
    return scene_.refuse(Code::edit_undercut, "LAYER " + std::to_string(layer) +
                                                  " WOULD BE SMALLER THAN LAYER " +
                                                  std::to_string(layer + 1));
  }
  return {};
}

Done LayerRules::settle(std::size_t layer) {
  if (is_same(regions_[layer], before_[layer])) return {};
  const auto contours = contours_of(regions_[layer]);
  if (!contours)
    return scene_.refuse(Code::edit_not_editable, "THE CONTOUR WOULD FALL INTO SEVERAL");
  contours_[layer] = *contours;
  is_other_[layer] = true;
  return {};
}

Done LayerRules::check_collision(std::size_t layer, Vec3 by) const {
  if (bounds_what_stands(its_)) return {};
  const Region more = contour::subtract(shifted(regions_[layer], Vec2{by.x, by.y}), before_[layer]);
  for (std::size_t other = 0; other < scene_.tree.features.size(); ++other) {
    const Feature& its_other = scene_.tree.features[other];
    const bool is_kin = (its_.parent && its_.parent->feature == other) ||
                        (its_other.parent && its_other.parent->feature == feature_);
    if (other == feature_ || is_kin || its_other.setup != its_.setup) continue;
    for (const Layer& level : its_other.layers) {
      const Layer& own = its_.layers[layer];
      const bool is_beside = level.z < own.top + by.z && own.z + by.z < level.top;
      if (!is_beside) continue;
      const double area = contour::area(contour::intersect(more, level.removed));
      if (area <= kEmptyArea_mm2) continue;
      auto collision =
          scene_.refuse(Code::edit_collides, "F" + std::to_string(feature_ + 1) +
                                                 " WOULD CUT INTO F" + std::to_string(other + 1) +
                                                 " BY " + base::rounded_text(area, 3) + " mm²");
      if (!scene_.allows_collision) return collision;
      scene_.plan.warnings.push_back(collision.value());
    }
  }
  return {};
}

}  // namespace kerf::features
