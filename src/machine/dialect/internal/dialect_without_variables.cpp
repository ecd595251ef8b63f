#include "machine/dialect/internal/dialect_without_variables.hpp"

#include "machine/dialect/refused.hpp"

namespace kerf::machine {

std::optional<base::Diagnostic> DialectWithoutVariables::start_entry(base::FileId file) {
  load_file(file);
  return start();
}

base::Outcome<Condition> DialectWithoutVariables::compile_condition(const std::string& /*text*/) {
  return refused(conditions_);
}

std::optional<bool> DialectWithoutVariables::holds(Condition& /*condition*/) {
  return std::nullopt;
}

std::optional<double> DialectWithoutVariables::variable(const std::string& /*name*/,
                                                        std::size_t /*level*/) {
  return std::nullopt;
}

base::Outcome<void> DialectWithoutVariables::set_variable_at(const std::string& name, double value,
                                                             std::size_t /*level*/) {
  return set_variable(name, value);
}

base::Outcome<void> DialectWithoutVariables::set_variable(const std::string& /*name*/,
                                                          double /*value*/) {
  return refused(variables_);
}

VariableListing DialectWithoutVariables::list_variables(std::span<const double> /*values*/,
                                                        std::size_t /*level*/) {
  return {};
}

}  // namespace kerf::machine
