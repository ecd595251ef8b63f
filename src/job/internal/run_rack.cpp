#include "job/internal/run_rack.hpp"

namespace kerf::job {

machine::ToolUse RunRack::use_of(std::uint32_t number) const {
  machine::ToolUse use{.turns = turns_};
  const auto known = axial_.find(number);
  use.cuts_only_along_axis = known != axial_.end() && known->second;
  if (number > 0 && number < memory_.tools.size())
    use.offset_radius_mm = memory_.tools[number].radius_geometry;
  if (turns_ && number < memory_.turning.size()) {
    use.offset_nose_mm = memory_.turning[number].geometry.radius;
    use.offset_tip = static_cast<int>(memory_.turning[number].tip);
  }
  return use;
}

const stock::CuttingTool& RunRack::tool(std::uint32_t number) {
  const auto known = ready_.find(number);
  if (known != ready_.end()) return known->second;
  machine::ChosenTool chosen = tools_.choose(static_cast<int>(number), use_of(number));
  for (std::string& what : chosen.assumed) assumed_.push_back({0, std::move(what)});
  has_guessed_ = has_guessed_ || chosen.tool.source == stock::ToolSource::assumed;
  chosen.tool.number = static_cast<int>(number);
  return ready_.emplace(number, stock::cutting_tool(chosen.tool, touch_mm_)).first->second;
}

}  // namespace kerf::job
