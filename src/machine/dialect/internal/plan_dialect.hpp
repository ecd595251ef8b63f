#pragma once

#include "control/plan/plan_control.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {

/// Motions that were planned before the run: of a drawing. The file is what the plan was made of.
class PlanDialect final : public Dialect {
 public:
  explicit PlanDialect(const Around& around);

  [[nodiscard]] std::string program_name() const override { return maker_->name(); }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void check(base::Findings& /*found*/) override {}
  [[nodiscard]] control::PlanControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  void load_file(base::FileId /*file*/) override {}

  std::shared_ptr<const control::MotionMaker> maker_;
  control::PlanControl control_;
  NoVariables variables_{base::Refusal::drawn_variables, base::Refusal::drawn_conditions};
};

}  // namespace kerf::machine
