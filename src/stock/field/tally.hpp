#pragma once

#include <array>
#include <bit>

#include "stock/field/field_tool.hpp"
#include "stock/field/lane_work.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {

/// What one sweep did in one tile, before it is added to its outcome. Heights and lengths in mm;
/// take_to() makes them volumes. Always of the whole tile, in the order of its blocks, so that the
/// sums are the same whoever works on it.
class Tally {
 public:
  /// Empty, for a sweep of this tool. Precondition: is_empty().
  void begin(const FieldTool& tool);

  /// Columns of a block, those whose offsets from the way are known by them as well.
  void remove(const Lowered& lowered) {
    double removed = removed_;
    for (unsigned left = lowered.columns; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const auto height = static_cast<double>(lowered.by[i]);
      removed += height;
      if ((lowered.sided >> i & 1U) == 0) continue;
      const auto bin = static_cast<std::size_t>(lowered.bins[i]);
      across_[bin] += height;
      bins_ |= std::uint64_t{1} << bin;
    }
    removed_ = removed;
  }
  [[nodiscard]] Sides& sides() { return sides_; }
  void take_by_core(double height) { core_ += height; }
  void meet(ToolPart part, Vec3 at, double depth);
  void visit(std::uint64_t columns) { visited_ += columns; }
  [[nodiscard]] bool is_empty() const { return visited_ == 0; }
  /// A column was lowered.
  [[nodiscard]] bool has_removed() const { return removed_ > 0; }

  /// Adds all of it to an outcome; then it is empty.
  void take_to(Outcome& outcome, double cell_mm2);

 private:
  struct Met {
    Contact deepest;
    double depths = 0;
  };

  Sides sides_ = no_sides();
  double removed_ = 0;
  double core_ = 0;
  std::uint64_t visited_ = 0;
  std::array<double, Outcome::kBins> across_{};
  std::uint64_t bins_ = 0;  // those of across_ that are not 0
  static_assert(Outcome::kBins == 64);
  std::array<Met, kToolParts> met_{};
};

}  // namespace kerf::stock::field
