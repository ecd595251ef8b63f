#pragma once

#include <optional>
#include <vector>

#include "control/core/assumptions.hpp"
#include "job/stock_job.hpp"
#include "stock/cutting/cutting_tool.hpp"
#include "stock/cutting/survey.hpp"

namespace kerf::job {

/// What a survey and the tools of the run say together, frame of the stock. Without a survey
/// nothing is known.
class SurveyedTools {
 public:
  SurveyedTools() = default;
  SurveyedTools(const stock::Survey& survey, stock::ToolRack& rack, stock::Vec3 origin);

  /// Around every tip that cuts, X and Y widened by the radius of its tool. Nothing: none cuts.
  [[nodiscard]] const std::optional<stock::Bounds>& extents() const { return extents_; }
  /// Highest end of a move across Z.
  [[nodiscard]] const std::optional<double>& highest_across() const { return across_; }
  /// A tool stands tilted against Z somewhere, or has an undercut.
  [[nodiscard]] bool turned() const { return turned_; }
  [[nodiscard]] bool undercut() const { return undercut_; }
  [[nodiscard]] double usual_cell() const { return cell_for(smallest_mm_); }
  /// Cells by the smallest tool (stock.md §3): 1, 2 or 5 times a power of ten.
  [[nodiscard]] static double cell_for(std::optional<double> smallest_mm);

 private:
  std::optional<stock::Bounds> extents_;
  std::optional<double> across_;
  std::optional<double> smallest_mm_;
  bool turned_ = false;
  bool undercut_ = false;
};

/// The shape that lies on the table, or that the chuck of a machine that turns holds. Failure
/// (usage): the machine cannot have it.
[[nodiscard]] base::Outcome<stock::Workpiece> shape_of(const machine::StockWord& word, bool turns,
                                                       const SurveyedTools& tools,
                                                       std::vector<control::Assumption>& assumed);

}  // namespace kerf::job
