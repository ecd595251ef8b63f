#pragma once

#include <vector>

#include "features/plan/internal/edit_scene.hpp"
#include "features/plan/internal/feature_wish.hpp"
#include "geometry/contour/region.hpp"

namespace kerf::features {

[[nodiscard]] LayerContours contours_of(const Layer& layer);
[[nodiscard]] contour::Contour moved(contour::Contour contour, contour::Vec2 by);
[[nodiscard]] LayerContours moved(LayerContours contours, contour::Vec2 by);

/// What the contours of all layers of a feature become when some of them are edited
/// (feature-recognition §6), before the feature is moved as a whole.
class LayerRules {
 public:
  LayerRules(EditScene& scene, std::size_t feature);

  [[nodiscard]] Done follow(FeatureWish& wish);
  [[nodiscard]] bool is_other(std::size_t layer) const { return is_other_[layer]; }
  [[nodiscard]] const LayerContours& contours(std::size_t layer) const { return contours_[layer]; }
  /// With other features, where the layer lies when it is moved. One that is allowed is told.
  [[nodiscard]] Done check_collision(std::size_t layer, Vec3 by) const;

 private:
  [[nodiscard]] Done finish(std::size_t layer, const ContourEdit& edit, contour::Vec2 by);
  void follow_layer(std::size_t edited, const FeatureWish& wish);
  [[nodiscard]] Done check_undercut() const;
  [[nodiscard]] Done settle(std::size_t layer);

  EditScene& scene_;
  std::size_t feature_;
  const Feature& its_;
  std::vector<contour::Region> before_{};
  std::vector<contour::Region> regions_{};
  std::vector<LayerContours> contours_{};
  std::vector<bool> is_other_{};
};

}  // namespace kerf::features
