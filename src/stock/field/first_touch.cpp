#include "stock/field/first_touch.hpp"

#include <algorithm>

#include "stock/field/straight_leg.hpp"

namespace kerf::stock::field {
namespace {

constexpr int kHalvings = 52;

/// Whether any part of a tool comes below the columns of a block anywhere along a leg.
bool meets(const FieldTool& tool, const StraightLeg& leg, const BlockPoints& points, double base,
           const BlockValues& heights) {
  BlockValues low;
  low.fill(kNowhere);
  for (const FieldTool::Part& part : tool.parts) leg.lower(part.whole, points, base, low);
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    if (low[i] < heights[i]) return true;
  }
  return false;
}

/// Looks for a touch earlier than the one that is known: what lies along a way up to t is met once
/// t is late enough.
class Touch {
 public:
  Touch(const Columns& columns, const FieldTool& tool, const StraightWay& way)
      : columns_(columns), tool_(tool), way_(way), leg_(way) {}

  void look_at(std::size_t tile) {
    if (!may_meet(columns_.top_of(tile))) return;
    for (int block = 0; block < kTileBlocks * kTileBlocks; ++block) look_at(tile, block);
  }
  [[nodiscard]] std::optional<double> first() const { return first_; }

 private:
  [[nodiscard]] bool may_meet(double top) const {
    return leg_.box().low.z - columns_.grid().box.low.z < top;
  }

  void look_at(std::size_t tile, int block) {
    const BlockPoints points = columns_.points(tile, block);
    if (!may_meet(columns_.block_top(tile, block)) || !is_near(points)) return;
    const double base = columns_.grid().box.low.z;
    const BlockValues heights = columns_.tops(tile, block);
    if (!meets(tool_, leg_, points, base, heights)) return;
    double before = 0;
    double after = first_.value_or(1);
    if (meets(tool_, StraightLeg(part(way_, 0, 0)), points, base, heights)) after = 0;
    for (int i = 0; i < kHalvings && after > 0; ++i) {
      const double middle = (before + after) / 2;
      const bool met = meets(tool_, StraightLeg(part(way_, 0, middle)), points, base, heights);
      (met ? after : before) = middle;
    }
    first_ = after;
    leg_ = StraightLeg(part(way_, 0, after));
  }

  [[nodiscard]] bool is_near(const BlockPoints& points) const {
    const Bounds& box = leg_.box();
    return box.low.x - tool_.reach <= points.x[kBlockSide - 1] &&
           points.x[0] <= box.high.x + tool_.reach &&
           box.low.y - tool_.reach <= points.y[kBlockSide - 1] &&
           points.y[0] <= box.high.y + tool_.reach;
  }

  const Columns& columns_;
  const FieldTool& tool_;
  StraightWay way_;
  StraightLeg leg_;
  std::optional<double> first_;
};

}  // namespace

std::optional<double> first_touch(const Columns& columns, const FieldTool& tool,
                                  const StraightWay& way) {
  Touch touch(columns, tool, way);
  for (std::size_t tile = 0; tile < columns.grid().tiles(); ++tile) touch.look_at(tile);
  return touch.first();
}

}  // namespace kerf::stock::field
