#pragma once

#include "control/teach/teach_control.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {

/// Taught points (docs/teach.md). A program has no variables and calls nothing.
class TeachDialect final : public Dialect {
 public:
  explicit TeachDialect(const Around& around);

  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void check(base::Findings& found) override;
  [[nodiscard]] control::TeachControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  void load_file(base::FileId file) override { library_.load(file); }

  teach::TeachLibrary library_;
  control::TeachControl control_;
  NoVariables variables_{base::Refusal::taught_variables, base::Refusal::taught_conditions};
};

}  // namespace kerf::machine
