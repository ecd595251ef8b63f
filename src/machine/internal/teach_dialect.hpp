#pragma once

#include "base/program_name.hpp"
#include "control/teach_control.hpp"
#include "machine/dialect.hpp"

namespace kerf::machine {

/// Taught points (docs/teach.md). A program has no variables and calls nothing.
class TeachDialect final : public Dialect {
 public:
  explicit TeachDialect(const Around& around);

  void add_library_folder(const std::string& /*folder*/) override {}
  [[nodiscard]] std::string program_name() const override { return base::kUnnumberedProgram; }
  [[nodiscard]] std::optional<base::Diagnostic> start() override;
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> variable(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                    std::size_t level) override;
  void read_variables(std::vector<double>& values) override;
  [[nodiscard]] VariableListing list_variables(std::span<const double> values,
                                               std::size_t level) override;
  void check(base::Findings& found) override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  [[nodiscard]] std::vector<Variable> variables() override { return {}; }
  [[nodiscard]] control::TeachControl& control() override { return control_; }
  [[nodiscard]] const control::Control& control() const override { return control_; }

 private:
  void load_file(base::FileId file) override { library_.load(file); }

  teach::TeachLibrary library_;
  control::TeachControl control_;
};

}  // namespace kerf::machine
