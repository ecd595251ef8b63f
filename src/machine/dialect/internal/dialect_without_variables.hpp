#pragma once

#include "base/program_name.hpp"
#include "base/refusal.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {

/// A language whose programs have no number, no variables and no subprograms. What the panel asks
/// about variables is empty, and what it would set is refused with the words of the language.
class DialectWithoutVariables : public Dialect {
 public:
  void add_library_folder(const std::string& /*folder*/) override {}
  [[nodiscard]] std::string program_name() const override { return base::kUnnumberedProgram; }
  [[nodiscard]] std::optional<base::Diagnostic> start_entry(base::FileId file) override;
  [[nodiscard]] base::Outcome<Condition> compile_condition(const std::string& text) override;
  [[nodiscard]] std::optional<bool> holds(Condition& condition) override;
  [[nodiscard]] std::optional<double> variable(const std::string& name, std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable_at(const std::string& name, double value,
                                                    std::size_t level) override;
  [[nodiscard]] base::Outcome<void> set_variable(const std::string& name, double value) override;
  void read_variables(std::vector<double>& values) override { values.clear(); }
  [[nodiscard]] VariableListing list_variables(std::span<const double> values,
                                               std::size_t level) override;
  [[nodiscard]] std::vector<Variable> variables() override { return {}; }

 protected:
  /// `variables` refuses to set one, `conditions` a breakpoint with a condition.
  DialectWithoutVariables(const base::SourceSet& sources, base::Refusal variables,
                          base::Refusal conditions)
      : Dialect(sources), variables_(variables), conditions_(conditions) {}

 private:
  base::Refusal variables_;
  base::Refusal conditions_;
};

}  // namespace kerf::machine
