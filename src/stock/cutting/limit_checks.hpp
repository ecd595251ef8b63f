#pragma once

#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/judge.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/cutting/tool_record.hpp"

namespace kerf::stock {

/// Adds up what tools did, with their times, and holds it against what their makers allow and what
/// the spindle can (stock.md §5, §6): more by 2 % is told. What a motion removed that is thinner
/// than two cells, and a width that is more by no more than half a cell, is below what the model
/// can tell.
class LimitChecks final : public TimedCutSink {
 public:
  struct Settings {
    double grain_mm = 0;  ///< of the model
    double most_kw = 0;   ///< of the spindle; 0: not known
  };

  /// All must outlive this. The records are those of Cutter::tools(): each tool has its own before
  /// it has cut.
  LimitChecks(ToolRack& rack, Judge& judge, Findings& findings, std::vector<ToolRecord>& records,
              const Settings& settings)
      : rack_(rack), judge_(judge), findings_(findings), records_(records), settings_(settings) {}

  void take(const TimedCut& cut) override;

 private:
  void judge_limits(const TimedCut& cut);
  void hold(const TimedCut& cut, base::Code code, double value, double most, double slack,
            const char* unit);

  ToolRack& rack_;
  Judge& judge_;
  Findings& findings_;
  std::vector<ToolRecord>& records_;
  Settings settings_;
};

}  // namespace kerf::stock
