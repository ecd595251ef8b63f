#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/cutting/workpiece.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/sweep/cut_watch.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::job {

class Run;

/// What has been found so far, the first of it.
struct FoundSoFar {
  std::vector<output::StockFacts::Told> first;
  std::size_t count = 0;  ///< of all
};

/// A design that a part is seen against.
struct DesignInSight {
  std::string file;
  double tolerance_mm = 0;
  /// How far each place is from it, mm, frame of the stock: above 0 material is left, below 0 it is
  /// cut away. From any thread.
  std::function<std::vector<float>(std::span<const stock::Vec3>)> deviations_mm;
};

/// A pass over a program that is about to cut, for whoever looks on. What it refers to is there
/// until the pass is over.
struct PassBegin {
  const Run& run;
  stock::Vec3 origin;  ///< of the stock's zero, machine coordinates
  stock::Workpiece shape;
  output::StockFacts::Model facts;
  /// At most so many. On the thread that cuts.
  std::function<FoundSoFar(std::size_t most)> findings;
};

/// One that cuts a model.
struct ModelBegin : PassBegin {
  stock::Model& model;
  /// Another one as the model is before the first cut, with cells not larger than this; 0: with
  /// the same.
  std::function<std::unique_ptr<stock::Model>(double cell_mm)> like;
  double usual_cell_mm = 0;  ///< that the program's tools ask for; the model's may be larger
  /// The part is cut as in the pass before, only its pieces are looked at besides.
  bool is_like_before = false;
  std::optional<DesignInSight> design{};
};

/// One that cuts and burns a sheet.
struct SheetBegin : PassBegin {
  stock::sheet::Sheet& sheet;
  std::function<std::unique_ptr<stock::sheet::Sheet>()> like;  ///< another one, untouched
};

/// Looks on at a pass that cuts a model.
class ModelWatch : public base::Interface {
 public:
  [[nodiscard]] virtual stock::CutWatch& cuts() = 0;
  /// Gets the motions with their times.
  [[nodiscard]] virtual stock::TimedCutSink& times() = 0;
};

/// Looks on at a pass that cuts and burns a sheet.
class SheetWatch : public base::Interface {
 public:
  /// These have been cut, each by the motion of its number, rising.
  virtual void cut(std::span<const stock::sheet::Trace> traces,
                   std::span<const std::uint32_t> motions) = 0;
  /// These have been burnt, each up to its time, s of the run, rising.
  virtual void burn(std::span<const stock::sheet::Burn> burns, std::span<const double> until_s) = 0;
  /// Gets the motions that were cut with their times.
  [[nodiscard]] virtual stock::TimedCutSink& times() = 0;
};

/// Whoever looks on at a job. For each pass one watch is asked for; null: it is not looked at.
class JobWatch : public base::Interface {
 public:
  [[nodiscard]] virtual std::unique_ptr<ModelWatch> begins(const ModelBegin& pass) = 0;
  [[nodiscard]] virtual std::unique_ptr<SheetWatch> begins(const SheetBegin& pass) = 0;
};

}  // namespace kerf::job
