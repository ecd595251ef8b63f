#pragma once

#include <deque>
#include <span>
#include <vector>

#include "stock/dexel/tile_work.hpp"

namespace kerf::stock::dexel {

/// By how much a cut may be off with a fixed axis, for cells of this size (stock.md §4).
[[nodiscard]] double fixed_tolerance_mm(double cell_mm);

/// A body after its last sweep: what is in it there is gone.
struct Trail {
  bool is_cut = false;
  BodyId body = 0;
  Vec3 axis;
  Vec3 tip;

  [[nodiscard]] bool goes_on(const Sweep& sweep) const;
  [[nodiscard]] static Trail after(const Sweep& sweep, const Tool& tool);
};

/// The stock that sweeps go through.
struct StockPlace {
  Vec3 middle;  ///< of its box
  Vec3 half;    ///< of its box
  double cell_mm = 0;
  double block_mm = 0;  ///< from the middle of a block of dexels to its corner
};

/// Sweeps made ready for the tiles. The sweeps, the tools and this stay where they are meanwhile.
class Preparation {
 public:
  /// `trail`: of the sweep before these; afterwards of the last of them.
  Preparation(std::span<const Sweep> sweeps, const std::deque<Tool>& tools, const StockPlace& place,
              Trail& trail);
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  [[nodiscard]] std::span<const Task> tasks() const { return tasks_; }
  /// Holds what a task may touch, from the middle of the stock.
  [[nodiscard]] Bounds box(const Task& task) const;

 private:
  void add(const Sweep& sweep, const Tool& tool, std::span<const Stroke> strokes, bool follows);
  [[nodiscard]] const PosedTool& posed(const Sweep& sweep, const Tool& tool);
  void limit(PosedTool& posed, const TurningWay& way) const;

  StockPlace place_;
  std::vector<Stroke> strokes_;
  std::deque<PosedTool> posed_;
  bool has_fixed_ = false;  ///< the last posed tool is as it stands, and may be used again
  std::vector<Task> tasks_;
};

}  // namespace kerf::stock::dexel
