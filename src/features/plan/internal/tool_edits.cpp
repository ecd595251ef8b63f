#include "features/plan/internal/tool_edits.hpp"

#include <algorithm>
#include <map>

namespace kerf::features {

Done check_tool(EditScene& scene, std::uint32_t tool, const std::string& target) {
  std::string others;
  const auto add = [&](const std::string& name) {
    if (name != target) others += (others.empty() ? "" : ", ") + name;
  };
  for (std::size_t i = 0; i < scene.tree.features.size(); ++i) {
    if (scene.tree.features[i].tool == tool) add("F" + std::to_string(i + 1));
  }
  for (std::size_t i = 0; i < scene.tree.holes.size(); ++i) {
    if (scene.tree.holes[i].tool == tool) add("H" + std::to_string(i + 1));
  }
  if (!others.empty()) {
    return scene.refuse(base::Code::edit_tool_shared,
                        "T" + std::to_string(tool) + " ALSO CUTS " + others);
  }
  return scene.refuse(base::Code::edit_not_editable,
                      "TOOLS ARE NOT CHANGED SO FAR: CHANGE T, H AND D IN THEIR BLOCKS");
}

// A tool whose last feature goes stays in the program, and is told.
void tell_unused_tools(EditScene& scene) {
  std::map<std::uint32_t, int> left;
  const EditPlan& plan = scene.plan;
  for (std::size_t f = 0; f < scene.tree.features.size(); ++f) {
    const Feature& its = scene.tree.features[f];
    int& count = left[its.tool];
    for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
      const auto gone = std::pair(f, layer);
      count += static_cast<int>(std::count(plan.gone.begin(), plan.gone.end(), gone) == 0);
    }
    count += static_cast<int>(its.layers.empty());
  }
  for (std::size_t h = 0; h < scene.tree.holes.size(); ++h) {
    const bool stays = std::count(plan.gone_holes.begin(), plan.gone_holes.end(), h) == 0;
    for (const HoleStep& step : scene.tree.holes[h].steps)
      left[step.tool] += static_cast<int>(stays);
  }
  for (const auto& [tool, count] : left) {
    if (count > 0 || plan.changes_more) continue;
    scene.plan.warnings.push_back({base::Code::edit_tool_unused,
                                   "T" + std::to_string(tool) + " CUTS NOTHING ANY MORE", "",
                                   scene.edit});
  }
}

}  // namespace kerf::features
