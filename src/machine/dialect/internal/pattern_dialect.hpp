#pragma once

#include "machine/dialect/dialect.hpp"
#include "machine/dialect/internal/pattern_control.hpp"

namespace kerf::machine {

/// The listing of a pattern (docs/pattern.md). It has no variables and calls nothing, and nothing
/// of it is entered in MDI: a record goes on from where the last one ended.
class PatternDialect final : public Dialect {
 public:
  /// Precondition: the machine has a controller for patterns (PatternMachine::of()).
  explicit PatternDialect(const Around& around);

  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  void check(base::Findings& found) override;
  [[nodiscard]] PatternControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }
  [[nodiscard]] ProgramVariables& variables() override { return variables_; }
  [[nodiscard]] const ProgramVariables& variables() const override { return variables_; }

 private:
  void load_file(base::FileId file) override { library_.load(file); }

  PatternMachine machine_;
  PatternLibrary library_;
  PatternControl control_;
  NoVariables variables_{base::Refusal::pattern_variables, base::Refusal::pattern_conditions};
};

}  // namespace kerf::machine
