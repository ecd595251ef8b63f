#pragma once

#include <algorithm>
#include <array>

#include "stock/field/field_tool.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {

/// What one sweep did in one tile, before it is added to its outcome. Heights and lengths in mm;
/// add_to() makes them volumes. Always of the whole tile, in the order of its blocks, so that the
/// sums are the same whoever works on it.
class Tally {
 public:
  explicit Tally(const FieldTool& tool);

  /// A column at this signed distance from the way, kNowhere if that is not known, down from one
  /// height to another, over the bottom of the stock.
  void remove(float offset, float from, float to) {
    const auto height = static_cast<double>(from - to);
    removed_ += height;
    if (offset >= kNowhere) return;
    const float bin = std::clamp((offset + reach_) * bins_per_mm_, 0.0F, Outcome::kBins - 1.0F);
    across_[static_cast<std::size_t>(bin)] += height;
    left_ = std::max(left_, offset);
    right_ = std::min(right_, offset);
    highest_ = std::max(highest_, from);
    lowest_ = std::min(lowest_, to);
  }
  void take_by_core(double height) { core_ += height; }
  void meet(ToolPart part, Vec3 at, double depth);
  void visit(std::uint64_t columns) { visited_ += columns; }
  [[nodiscard]] bool is_empty() const { return visited_ == 0; }
  /// A column was lowered.
  [[nodiscard]] bool has_removed() const { return removed_ > 0; }

  void add_to(Outcome& outcome, double cell_mm2) const;

 private:
  struct Met {
    Contact deepest;
    double depths = 0;
  };

  float bins_per_mm_;
  float reach_;
  float left_ = -kNowhere;
  float right_ = kNowhere;
  float highest_ = -kNowhere;
  float lowest_ = kNowhere;
  double removed_ = 0;
  double core_ = 0;
  std::uint64_t visited_ = 0;
  std::array<double, Outcome::kBins> across_{};
  std::array<Met, kToolParts> met_{};
};

}  // namespace kerf::stock::field
