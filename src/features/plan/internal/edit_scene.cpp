#include "features/plan/internal/edit_scene.hpp"

namespace kerf::features {

tl::unexpected<EditFault> EditScene::refuse(base::Code code, std::string sentence,
                                            std::string hint) const {
  return tl::unexpected(EditFault{code, std::move(sentence), std::move(hint), edit});
}

std::optional<std::size_t> EditScene::feature_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    if (target == "F" + std::to_string(i + 1) || target == tree.features[i].key) return i;
  }
  return std::nullopt;
}
std::optional<std::size_t> EditScene::hole_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree.holes.size(); ++i) {
    if (target == "H" + std::to_string(i + 1) || target == tree.holes[i].key) return i;
  }
  return std::nullopt;
}
std::optional<std::size_t> EditScene::pattern_of(const std::string& target) const {
  for (std::size_t i = 0; i < tree.patterns.size(); ++i) {
    if (target == "P" + std::to_string(i + 1)) return i;
  }
  return std::nullopt;
}

tl::unexpected<EditFault> EditScene::refuse(EditFault fault) const {
  fault.edit = edit;
  return tl::unexpected(std::move(fault));
}

}  // namespace kerf::features
