#include "features/plan/internal/contour_limits.hpp"

#include "base/decimal.hpp"
#include "features/path/tolerance.hpp"
#include "features/rewrite/regenerate.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"

namespace kerf::features {

using base::Code;
using contour::Region;

Done check_undercut(EditScene& scene, std::size_t feature, const std::vector<Region>& regions) {
  const bool stands = bounds_what_stands(scene.tree.features[feature]);
  for (std::size_t layer = 1; layer < regions.size(); ++layer) {
    const Region& upper = regions[stands ? layer : layer - 1];
    const Region& lower = regions[stands ? layer - 1 : layer];
    const Region under = contour::offset(contour::subtract(lower, upper), -kSamePoint_mm);
    if (contour::area(under) <= kEmptyArea_mm2) continue;
    return scene.refuse(Code::edit_undercut, "LAYER " + std::to_string(layer) +
                                                 " WOULD BE SMALLER THAN LAYER " +
                                                 std::to_string(layer + 1));
  }
  return {};
}

Done check_collision(EditScene& scene, std::size_t feature, std::size_t layer, const Region& before,
                     const Region& now) {
  const Feature& its = scene.tree.features[feature];
  if (bounds_what_stands(its)) return {};
  const Region more = contour::subtract(now, before);
  for (std::size_t other = 0; other < scene.tree.features.size(); ++other) {
    const Feature& its_other = scene.tree.features[other];
    const bool is_kin = (its.parent && its.parent->feature == other) ||
                        (its_other.parent && its_other.parent->feature == feature);
    if (other == feature || is_kin || its_other.setup != its.setup) continue;
    for (const Layer& level : its_other.layers) {
      const bool is_beside = level.z < its.layers[layer].top && its.layers[layer].z < level.top;
      if (!is_beside) continue;
      const double area = contour::area(contour::intersect(more, level.removed));
      if (area <= kEmptyArea_mm2) continue;
      auto collision =
          scene.refuse(Code::edit_collides, "F" + std::to_string(feature + 1) +
                                                " WOULD CUT INTO F" + std::to_string(other + 1) +
                                                " BY " + base::rounded_text(area, 3) + " mm²");
      if (!scene.allows_collision) return collision;
      scene.plan.warnings.push_back(collision.value());
    }
  }
  return {};
}

}  // namespace kerf::features
