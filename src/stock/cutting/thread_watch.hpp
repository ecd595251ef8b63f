#pragma once

#include <span>
#include <vector>

#include "stock/cutting/cut_thread.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/spindles.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock {

/// A motion at feed of a tool, and what it did.
struct ThreadMove {
  const CuttingTool& tool;
  base::BlockId block;
  std::uint64_t motion = 0;
  Turning spindle = Turning::stopped;
  std::span<const Sweep> sweeps{};
  std::span<const Outcome> outcomes{};
};

/// Finds the threads of taps and thread mills by their ways, and in the end how far they are in
/// material.
///
///   tap           straight down its axis while it turns; the full profile ends two pitches above
///                 its tip, where its chamfer ends
///   thread mill   about one centre with one radius for a turn or more, going along its axis: the
///                 way's rise in a turn is the lead
///
/// Threads of the basic profile (ISO 68-1), whose minor diameter is 1.082531755 P less than the
/// major one, or as deep as the teeth of the mill.
class ThreadWatch {
 public:
  void take(const ThreadMove& move);
  /// Those that the part still has, in the order in which they were begun.
  [[nodiscard]] std::vector<CutThread> threads(const Model& model, ToolRack& rack) const;

 private:
  struct Entry {
    CutThread thread;
    Vec3 axis;       ///< unit, up along the tool
    Vec3 centre;     ///< a point of the axis of the thread
    double low = 0;  ///< of the full profile, along the axis from the centre
    double high = 0;
    double radius = 0;    ///< of a milled one: of the way
    double turn_rad = 0;  ///< likewise, all of it
    double rise_mm = 0;
    double outside_mm3 = 0;  ///< removed on the far side of the way from its centre, less the near
  };

  void take_tap(const ThreadMove& move);
  void take_mill(const ThreadMove& move);
  void take_turn(const ThreadMove& move, const Sweep& sweep, const ArcWay& arc,
                 const Outcome& outcome);
  [[nodiscard]] Entry& entry_of(const Entry& like);
  [[nodiscard]] static bool complete(Entry& entry, const CuttingTool& tool);
  [[nodiscard]] static bool clip(Entry& entry, const Model& model);
  [[nodiscard]] static double groove_mm3(const CutThread& thread);

  std::vector<Entry> entries_;
};

}  // namespace kerf::stock
