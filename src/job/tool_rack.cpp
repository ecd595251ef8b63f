#include "job/tool_rack.hpp"

#include <map>

namespace kerf::job {
namespace {

using stock::Measure;
using stock::Tool;

constexpr double kAssumedDiameter_mm = 6;
constexpr double kTouch_mm = 0.01;

Tool flat(std::uint32_t number, double diameter_mm, stock::ToolSource source) {
  Tool tool{.number = static_cast<int>(number), .source = source};
  tool.measures.set(Measure::diameter, diameter_mm);
  return tool;
}

class Rack final : public stock::ToolRack {
 public:
  Rack(std::vector<Tool> tools, const control::Memory& memory)
      : tools_(std::move(tools)), memory_(memory) {}

  const stock::CuttingTool& tool(std::uint32_t number) override {
    const auto known = ready_.find(number);
    if (known != ready_.end()) return known->second;
    return ready_.emplace(number, stock::cutting_tool(choose(number), kTouch_mm)).first->second;
  }

 private:
  [[nodiscard]] Tool choose(std::uint32_t number) const {
    for (const Tool& tool : tools_) {
      if (tool.number == static_cast<int>(number) && !tool.is_insert() && objection(tool).empty())
        return tool;
    }
    const bool has_offset = number > 0 && number < memory_.tools.size();
    const double radius = has_offset ? memory_.tools[number].radius_geometry : 0;
    if (radius > 0) return flat(number, 2 * radius, stock::ToolSource::offset);
    return flat(number, kAssumedDiameter_mm, stock::ToolSource::assumed);
  }

  std::vector<Tool> tools_;
  const control::Memory& memory_;
  std::map<std::uint32_t, stock::CuttingTool> ready_;
};

}  // namespace

std::unique_ptr<stock::ToolRack> make_rack(std::vector<Tool> tools, const control::Memory& memory) {
  return std::make_unique<Rack>(std::move(tools), memory);
}

}  // namespace kerf::job
