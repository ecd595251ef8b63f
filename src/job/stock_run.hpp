#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "job/motion_lines.hpp"
#include "job/run.hpp"
#include "job/stock_job.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/cutting/cutter.hpp"
#include "stock/sheet/sheet.hpp"

namespace kerf::job {

/// What a run that cut the part has left.
struct StockResult {
  std::unique_ptr<Run> run;  ///< over: its sources, what it came to
  machine::RunStatus status{};
  bool is_stopped = false;  ///< at the first finding; the run itself went on
  machine::StockZero zero;  ///< that it stood at; never automatic
  stock::Vec3 origin;       ///< of that, machine coordinates
  stock::Workpiece shape = stock::BoxShape{};
  double wanted_cell_mm = 0;  ///< that the cells should have had
  double cell_mm = 0;         ///< that they were made by; 0: the model has none
  output::StockFacts::Model model_facts;
  std::unique_ptr<stock::Model> model;    ///< null: the stock is a sheet
  std::unique_ptr<stock::ToolRack> rack;  ///< the run's; null: of a sheet
  std::unique_ptr<stock::sheet::Sheet> sheet;
  std::optional<output::StockFacts::Sheet> sheet_facts;  ///< of it
  std::vector<stock::Finding> findings;
  std::optional<output::StockFacts::Compared> compare;  ///< with a design; compare_with_design()
  std::optional<output::StockFacts::Against> against;   ///< compare_with_other()
  std::uint64_t findings_dropped = 0;
  std::vector<stock::ToolRecord> tools;
  std::vector<stock::ToolSpan> tool_spans;  ///< which motions are whose
  std::vector<stock::sheet::Trace> ways;    ///< of a beam, where the job keeps them
  std::vector<std::uint32_t> way_motions;   ///< that made those
  std::vector<stock::Piece> pieces;         ///< of the model, the largest first
  std::vector<output::StockFacts::Thread> threads;
  machine::Skips skips;      ///< what probes met: Job::skips of a run that shall be the same
  bool has_probed = false;   ///< whether they might have met anything
  bool knows_stock = true;   ///< as the job has it
  bool knows_travel = true;  ///< some offset or length is not 0: the limits of strokes count
  double most_kw = 0;        ///< of the spindle; 0: not known
  bool knows_material = false;
  MotionLines lines;                          ///< of a job that compares
  std::unique_ptr<stock::TimedCutSink> rows;  ///< of StockJob::rows, all told; null: none
  std::vector<control::Assumption> assumed;
};

/// Runs the job and cuts its stock: as often as it takes to know what stands on the table and which
/// model can hold it, mostly once. Failures as Run::of() has them, and (usage) for a stock that the
/// machine cannot have.
[[nodiscard]] base::Outcome<StockResult> cut_stock(const StockJob& job);

}  // namespace kerf::job
