#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "control/plan/motion_maker.hpp"
#include "drawing/cleaning.hpp"
#include "drawing/contours/contour_layer.hpp"
#include "drawing/nesting.hpp"
#include "job/drawing/draw_order.hpp"
#include "process/plan.hpp"
#include "process/recipe_file.hpp"
#include "process/sheet.hpp"

namespace kerf::job {

/// Drawings that were read, cleaned and planned; a machine can make it.
class DrawnPlan final : public control::MotionMaker {
 public:
  /// Failure (input): a file cannot be opened. What is wrong in it is a finding.
  [[nodiscard]] static base::Outcome<std::shared_ptr<const DrawnPlan>> of(const DrawOrder& order);

  // control::MotionMaker
  [[nodiscard]] std::unique_ptr<control::MotionStream> stream() const override;
  [[nodiscard]] std::string name() const override;

  [[nodiscard]] const base::SourceSet& sources() const { return sources_; }
  /// By FileId.
  [[nodiscard]] std::vector<std::string> file_names() const;
  [[nodiscard]] const drawing::Drawing& drawing() const { return drawing_; }
  [[nodiscard]] const drawing::Cleaned& cleaned() const { return cleaned_; }
  [[nodiscard]] const process::Sheet& sheet() const { return sheet_; }
  /// How the contours lie in each other, before they are placed.
  [[nodiscard]] const std::vector<drawing::Nest>& nests() const { return nests_; }
  [[nodiscard]] const process::Plan& plan() const { return plan_; }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }
  /// Of the drawing, then of the plan.
  [[nodiscard]] std::vector<drawing::Finding> findings() const;
  /// What is wrong in the job where it meets materials and machine; places are those of the job
  /// file.
  [[nodiscard]] const process::Diagnostics& job_findings() const { return job_findings_; }
  /// An error was found: nothing may be written.
  [[nodiscard]] bool is_wrong() const;

 private:
  explicit DrawnPlan(const DrawOrder& order);
  [[nodiscard]] base::Outcome<void> make();

  DrawOrder order_;
  base::SourceSet sources_;
  drawing::Drawing drawing_;
  drawing::Cleaned cleaned_;
  std::vector<drawing::Nest> nests_;
  process::Sheet sheet_;
  std::vector<std::string> texts_;
  process::Plan plan_;
  process::Diagnostics job_findings_;
};

/// What was read and cleaned, before it is placed, by layer.
[[nodiscard]] std::vector<drawing::ContourLayer> layers_of(const DrawnPlan& plan);

/// What a plan has to know of a machine.
[[nodiscard]] process::MachineFacts facts_of(const machine::MachineDefinition& definition);

}  // namespace kerf::job
