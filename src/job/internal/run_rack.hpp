#pragma once

#include <map>
#include <vector>

#include "control/core/assumptions.hpp"
#include "control/core/memory.hpp"
#include "job/stock_job.hpp"
#include "machine/definition/tools/tool_choice.hpp"
#include "machine/run/batch_run.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/driven_tools.hpp"

namespace kerf::job {

/// The tools of a run as it asks for them (stock.md §1.5).
class RunRack final : public stock::ToolRack {
 public:
  /// Tools of which all moves at feed go along Z, by a survey; empty: there was none.
  using AxialTools = std::map<std::uint32_t, bool>;
  /// Of a lathe those that turn themselves.
  using Driven = std::map<std::uint32_t, stock::DrivenTool>;

  /// All must outlive the rack.
  RunRack(const StockJob& job, const machine::BatchRun& run, AxialTools axial, Driven driven = {})
      : tools_(job.tools),
        memory_(run.memory()),
        turns_(run.definition().turns()),
        touch_mm_(job.touch_mm),
        axial_(std::move(axial)),
        driven_(std::move(driven)) {}

  [[nodiscard]] const stock::CuttingTool& tool(std::uint32_t number) override;

  /// What nobody has said of the tools that were asked for.
  [[nodiscard]] const std::vector<control::Assumption>& assumed() const { return assumed_; }
  /// One of them is assumed altogether.
  [[nodiscard]] bool has_guessed() const { return has_guessed_; }

 private:
  void stand(stock::CuttingTool& tool, const stock::DrivenTool& driven);
  [[nodiscard]] machine::ToolUse use_of(std::uint32_t number) const;

  const machine::ToolChoice& tools_;
  const control::Memory& memory_;
  bool turns_;
  double touch_mm_;
  AxialTools axial_;
  Driven driven_;
  std::map<std::uint32_t, stock::CuttingTool> ready_;
  std::vector<control::Assumption> assumed_;
  bool has_guessed_ = false;
};

}  // namespace kerf::job
