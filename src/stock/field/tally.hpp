#pragma once

#include <array>

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

  /// What columns are lowered by goes there.
  [[nodiscard]] Taken& taken() { return taken_; }
  void take_by_core(double height) { core_ += height; }
  void meet(ToolPart part, Vec3 at, double depth);
  void visit(std::uint64_t columns) { visited_ += columns; }
  [[nodiscard]] bool is_empty() const { return visited_ == 0; }
  /// A column was lowered.
  [[nodiscard]] bool has_removed() const { return removed() > 0; }

  /// Adds all of it to an outcome; then it is empty.
  void take_to(Outcome& outcome, double cell_mm2);

 private:
  struct Met {
    Contact deepest;
    double depths = 0;
  };

  [[nodiscard]] double removed() const {
    const auto& of = taken_.heights;
    return (of[0] + of[1]) + (of[2] + of[3]);
  }
  void take_sides(Outcome& outcome, double cell_mm2);
  void take_contacts(Outcome& outcome, double cell_mm2);

  Taken taken_;
  double core_ = 0;
  std::uint64_t visited_ = 0;
  bool has_met_ = false;
  std::array<Met, kToolParts> met_{};
};

}  // namespace kerf::stock::field
