#include "stock/field/settling.hpp"

#include <algorithm>

namespace kerf::stock::field {

Settling::Settling(const ReadySweep& sweep, const BlockPoints& points, double base)
    : sweep_(sweep), points_(points), base_(base) {
  const FieldTool& tool = *sweep.tool;
  for (Part& part : parts_) part.shrunk.fill(kNowhere);
  for_each_leg(sweep.legs, [&](const auto& leg) {
    if (!reaches(leg, tool.reach)) return;
    const FieldTool::Part& edges = tool.part(ToolPart::edge);
    if (sweep.cuts) add_edges(leg, edges);
    for (std::size_t i = 0; i < kToolParts; ++i) {
      const FieldTool::Part& part = tool.parts[i];
      if (!sweep.guards(static_cast<ToolPart>(i)) || part.whole.is_empty()) continue;
      add(leg, part.whole, part.top, parts_[i].whole);
      leg.view(part.shrunk, base_, {}).lower(points_, parts_[i].shrunk);
    }
  });
}

bool Settling::reaches(const auto& leg, double reach) const {
  const Bounds& box = leg.box();
  return box.low.x - reach <= points_.x[kBlockSide - 1] && points_.x[0] <= box.high.x + reach &&
         box.low.y - reach <= points_.y[kBlockSide - 1] && points_.y[0] <= box.high.y + reach;
}

void Settling::add(const auto& leg, const LowerEnvelope& body, double top, Spans& spans) const {
  BlockValues low;
  low.fill(kNowhere);
  leg.view(body, base_, {}).lower(points_, low);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    if (low[i] >= kNowhere) continue;
    const double tip = leg.highest_tip(body.reach(), points_.x_of(i), points_.y_of(i));
    const auto lowest = static_cast<double>(low[i]);
    spans[i].low = std::min(spans[i].low, lowest);
    spans[i].high = std::max({spans[i].high, tip + top - base_, lowest});
  }
}

void Settling::add_edges(const auto& leg, const FieldTool::Part& edges) {
  const Spans before = edges_;
  add(leg, edges.whole, edges.top, edges_);
  BlockValues here;
  leg.offsets(points_, here);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    if (edges_[i].low < before[i].low) offsets_[i] = here[i];
  }
}

Meeting Settling::meets(ToolPart part, std::size_t i, Span material) const {
  if (!sweep_.guards(part)) return {};
  const Part& spans = parts_[index(part)];
  return meet(material, edges_[i], {spans.whole[i], static_cast<double>(spans.shrunk[i])},
              sweep_.tool->touch_mm);
}

}  // namespace kerf::stock::field
