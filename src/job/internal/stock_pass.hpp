#pragma once

#include <map>
#include <optional>

#include "job/run.hpp"
#include "job/stock_job.hpp"
#include "stock/cutting/cutter.hpp"
#include "stock/cutting/driven_tools.hpp"
#include "stock/cutting/survey.hpp"

namespace kerf::job {

/// What a pass over the program is begun with: partly known, partly supposed.
struct StockPlan {
  stock::Vec3 origin;            ///< of the stock's zero, machine coordinates
  bool without_changes = false;  ///< the program changes no tool: all of it is T0's
  stock::Workpiece shape = stock::BoxShape{};
  StockModel kind = StockModel::zmap;
  std::string reason;
  double cell_mm = 0;
  bool is_compared = false;            ///< what that takes is kept beside the model
  std::size_t lines_bytes = 0;         ///< of MotionLines, as far as they are known
  std::optional<stock::CutEnd> end{};  ///< none: all is cut
  bool is_stopped = false;             ///< `end` is that of the first finding
  std::vector<std::uint64_t> looks{};  ///< LoosePieces: motions behind which pieces are looked at
  bool is_surveyed = false;
  bool is_beside_middle = false;  ///< of a lathe: a turning tool leaves the plane of Z and X
  std::map<std::uint32_t, bool> axial{};  ///< tools that only go down, by the survey
  /// Of a lathe the tools that turn themselves, and what a pass before has seen them do.
  std::map<std::uint32_t, stock::DrivenTool> driven{};
};

/// Where a zero lies now, machine coordinates: that of a work system with EXT, without shifts; of
/// another kind the machine's own.
[[nodiscard]] stock::Vec3 origin_of(const machine::BatchRun& run, const machine::StockZero& zero);

/// The zero of the stock as the run has it: a sink that looks at the control whenever a move cuts.
class ZeroWatch {
 public:
  /// The run must outlive the watch.
  ZeroWatch(const machine::BatchRun& run, const machine::StockZero& wanted);

  /// A move cuts, or is about to meet the stock with a probe.
  void look(const base::BlockId& block);
  /// What stands before anything ran.
  [[nodiscard]] stock::Vec3 at_start() const { return at_start_; }

  /// Found: where it was at the first move that cut in it.
  [[nodiscard]] const std::optional<stock::Vec3>& origin() const { return origin_; }
  [[nodiscard]] const machine::StockZero& zero() const { return zero_; }
  /// The first block that cut with the zero elsewhere.
  [[nodiscard]] const std::optional<base::BlockId>& moved() const { return moved_; }

 private:
  [[nodiscard]] bool in_force() const;

  const machine::BatchRun& run_;
  machine::StockZero zero_;
  stock::Vec3 at_start_;
  std::optional<stock::Vec3> origin_;
  std::optional<base::BlockId> moved_;
  std::uint64_t revision_ = 0;
};

}  // namespace kerf::job
