#include "job/internal/run_rack.hpp"

#include <fmt/format.h>

namespace kerf::job {

machine::ToolUse RunRack::use_of(std::uint32_t number) const {
  const auto driven = driven_.find(number);
  machine::ToolUse use{.turns = turns_ && driven == driven_.end()};
  const auto known = axial_.find(number);
  use.cuts_only_along_axis = known != axial_.end() && known->second;
  if (driven != driven_.end()) use.cuts_only_along_axis = driven->second.is_axial;
  if (number > 0 && number < memory_.tools.size())
    use.offset_radius_mm = memory_.tools[number].radius_geometry;
  if (use.turns && number < memory_.turning.size()) {
    use.offset_nose_mm = memory_.turning[number].geometry.radius;
    use.offset_tip = static_cast<int>(memory_.turning[number].tip);
  }
  return use;
}

void RunRack::stand(stock::CuttingTool& tool, const stock::DrivenTool& driven) {
  tool.driven = driven.axis;
  if (!driven.is_guess) return;
  const bool is_in_face = driven.axis.z != 0;
  assumed_.push_back({0, fmt::format("T{}: driven along {}, as its first straight cut goes",
                                     tool.number(), is_in_face ? 'Z' : 'X')});
}

const stock::CuttingTool& RunRack::tool(std::uint32_t number) {
  const auto known = ready_.find(number);
  if (known != ready_.end()) return known->second;
  machine::ChosenTool chosen = tools_.choose(static_cast<int>(number), use_of(number));
  for (std::string& what : chosen.assumed) assumed_.push_back({0, std::move(what)});
  has_guessed_ = has_guessed_ || chosen.tool.source == stock::ToolSource::assumed;
  chosen.tool.number = static_cast<int>(number);
  stock::CuttingTool& tool =
      ready_.emplace(number, stock::cutting_tool(chosen.tool, touch_mm_)).first->second;
  const auto driven = driven_.find(number);
  if (driven != driven_.end() && !tool.tool.is_insert()) stand(tool, driven->second);
  return tool;
}

}  // namespace kerf::job
