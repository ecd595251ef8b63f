#pragma once

#include <vector>

#include "motion/curve.hpp"
#include "stock/cutting/work_frame.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock {

/// The curves of moves as sweeps of a tool over the stock: lines and arcs stay what they are while
/// the work does not turn, everything else is divided so that no point of the tool leaves its way
/// by more than a tolerance (stock.md §4.4).
class SweepMaker {
 public:
  /// The frame must outlive this. tolerance > 0, mm.
  SweepMaker(const WorkFrame& frame, double tolerance_mm)
      : frame_(frame), tolerance_mm_(tolerance_mm) {}

  /// Adds the sweeps of a curve that begins at `from` to `sweeps`. `like` has what they have in
  /// common, its axis that of the tool in the machine; `reach_mm`: no point of the tool is farther
  /// than that from its tip.
  void add(const base::TipPoint& from, const motion::Curve& curve, const Sweep& like,
           double reach_mm, std::vector<Sweep>& sweeps) const;

 private:
  void add_turning(const base::TipPoint& from, const motion::Curve& curve, const Sweep& like,
                   double reach_mm, std::vector<Sweep>& sweeps) const;
  void add_divided(const motion::Curve& curve, const Sweep& like, std::vector<Sweep>& sweeps) const;
  [[nodiscard]] ArcWay arc_way(const base::TipPoint& from, const motion::Curve& curve) const;

  const WorkFrame& frame_;
  double tolerance_mm_;
};

}  // namespace kerf::stock
