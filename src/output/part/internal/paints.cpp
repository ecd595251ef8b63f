#include "output/part/internal/paints.hpp"

#include "stock/surface/turned_surface.hpp"

namespace kerf::output::plot {
namespace {

/// Large faces want paler colours than lines.
Color paler(Color color) {
  const auto mixed = [](std::uint8_t part) {
    return static_cast<std::uint8_t>((part * 72 + 255 * 28) / 100);
  };
  return {mixed(color.red), mixed(color.green), mixed(color.blue)};
}

}  // namespace

Paints::Paints(const PartScene& scene)
    : scene_(scene), colors_{kUncut, kFixturePaint, kSectionPaint} {
  for (std::size_t i = 0; i < scene.facts->tools.size(); ++i) {
    of_number_.emplace(scene.facts->tools[i].did.tool, static_cast<std::uint16_t>(colors_.size()));
    colors_.push_back(paler(kToolColors[i % kToolColors.size()]));
  }
}

std::uint16_t Paints::of_motion(std::uint32_t motion) const {
  if (motion == stock::surface::kSection) return kSection;
  const auto tool = stock::tool_at(scene_.tools, motion);
  const auto found = tool ? of_number_.find(*tool) : of_number_.end();
  return found == of_number_.end() ? kStock : found->second;
}

}  // namespace kerf::output::plot
