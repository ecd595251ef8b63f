#include "features/plan/internal/edit_scene.hpp"

#include <algorithm>

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

std::optional<std::vector<PlannedRow>> EditScene::take_rows(Span rows) {
  const auto meets = [&](const Stretch& each) {
    return each.rows.first <= rows.last && each.rows.last >= rows.first;
  };
  for (const Stretch& each : plan.rows) {
    const bool is_within = each.rows.first >= rows.first && each.rows.last <= rows.last;
    if (meets(each) && !is_within) return std::nullopt;
  }
  std::vector<PlannedRow> taken;
  for (std::uint32_t row = rows.first; row <= rows.last;) {
    const auto known = std::find_if(plan.rows.begin(), plan.rows.end(),
                                    [&](const Stretch& each) { return each.rows.first == row; });
    if (known == plan.rows.end()) {
      taken.push_back(as_it_is(recording, row++));
      continue;
    }
    taken.insert(taken.end(), known->becomes.begin(), known->becomes.end());
    row = known->rows.last + 1;
  }
  std::erase_if(plan.rows, meets);
  return taken;
}

tl::unexpected<EditFault> EditScene::refuse(EditFault fault) const {
  fault.edit = edit;
  return tl::unexpected(std::move(fault));
}

}  // namespace kerf::features
