#include "features/plan/internal/order_edit.hpp"

#include <algorithm>

namespace kerf::features {
using base::Code;

Done change_order(EditScene& scene, const ChangeOrder& order, const std::string& target) {
  const auto spans_of =
      [&](const std::string& name) -> std::optional<std::pair<Span, std::uint32_t>> {
    std::vector<Span> visits;
    std::uint32_t tool = 0;
    if (const auto feature = scene.feature_of(name)) {
      tool = scene.tree.features[*feature].tool;
      for (const Layer& layer : scene.tree.features[*feature].layers)
        visits.insert(visits.end(), layer.visits.begin(), layer.visits.end());
    } else if (const auto hole = scene.hole_of(name)) {
      tool = scene.tree.holes[*hole].tool;
      for (const auto& step : scene.tree.holes[*hole].steps)
        visits.insert(visits.end(), step.visits.begin(), step.visits.end());
    }
    if (visits.empty()) return std::nullopt;
    Span whole = visits.front();
    for (const Span& visit : visits)
      whole = {std::min(whole.first, visit.first), std::max(whole.last, visit.last)};
    return std::pair(whole, tool);
  };
  const auto moved = spans_of(target);
  const auto other = spans_of(order.other);
  if (!moved || !other)
    return scene.refuse(Code::edit_feature_unknown, "NO FEATURE " + (moved ? order.other : target));
  if (moved->second != other->second) {
    return scene.refuse(Code::edit_order, target + " IS CUT BY T" + std::to_string(moved->second) +
                                              ", " + order.other + " BY T" +
                                              std::to_string(other->second));
  }
  const Span whole{std::min(moved->first.first, other->first.first),
                   std::max(moved->first.last, other->first.last)};
  const auto in_moved = [&](std::uint32_t row) {
    return row >= moved->first.first && row <= moved->first.last;
  };
  Stretch stretch{.rows = whole};
  const auto put = [&](bool of_moved) {
    for (std::uint32_t row = whole.first; row <= whole.last; ++row) {
      if (in_moved(row) != of_moved) continue;
      PlannedRow planned = as_it_is(scene.recording, row);
      planned.changes_place = of_moved;
      stretch.becomes.push_back(planned);
    }
  };
  put(order.is_before);
  put(!order.is_before);
  scene.add(std::move(stretch));
  return {};
}

}  // namespace kerf::features
