#pragma once

#include "base/program_name.hpp"
#include "machine/dialect.hpp"
#include "machine/internal/pattern_control.hpp"

namespace kerf::machine {

/// The listing of a pattern (docs/pattern.md). It has no variables and calls nothing, and nothing
/// of it is entered in MDI: a record goes on from where the last one ended.
class PatternDialect final : public Dialect {
 public:
  /// Precondition: the machine has a controller for patterns (PatternMachine::of()).
  explicit PatternDialect(const Around& around);

  void add_library_folder(const std::string& /*folder*/) override {}
  [[nodiscard]] std::string program_name() const override { return base::kUnnumberedProgram; }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> variable(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                    std::size_t level) override;
  void read_variables(std::vector<double>& values) override { values.clear(); }
  [[nodiscard]] VariableListing list_variables(std::span<const double> values,
                                               std::size_t level) override;
  void check(base::Findings& found) override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> variables() override { return {}; }
  [[nodiscard]] PatternControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }

 private:
  void load_file(base::FileId file) override { library_.load(file); }

  PatternMachine machine_;
  PatternLibrary library_;
  PatternControl control_;
};

}  // namespace kerf::machine
