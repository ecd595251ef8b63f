#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/interface.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/cutting/workpiece.hpp"
#include "stock/sweep/cut_watch.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::job {

class Run;

/// A pass over a program that is about to cut, for whoever looks on. What it refers to is there
/// until the pass is over.
struct PassBegin {
  const Run& run;
  stock::Vec3 origin;  ///< of the stock's zero, machine coordinates
  stock::Workpiece shape;
  output::StockFacts::Model facts;
  stock::Model& model;
  /// Another one as the model is before the first cut, with cells not larger than this; 0: with
  /// the same.
  std::function<std::unique_ptr<stock::Model>(double cell_mm)> like;
  double usual_cell_mm = 0;  ///< that the program's tools ask for; the model's may be larger
  /// The part is cut as in the pass before; only its pieces are looked at besides.
  bool is_like_before = false;
  /// What has been found so far. On the thread that cuts.
  std::function<std::vector<output::StockFacts::Told>()> findings;
};

/// Looks on at one pass.
class PassWatch : public base::Interface {
 public:
  [[nodiscard]] virtual stock::CutWatch& cuts() = 0;
  /// Gets the motions with their times.
  [[nodiscard]] virtual stock::TimedCutSink& times() = 0;
};

}  // namespace kerf::job
