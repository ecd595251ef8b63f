#include "machine/dialect/program_variables.hpp"

#include "machine/dialect/refused.hpp"

namespace kerf::machine {

base::Outcome<Condition> NoVariables::compile_condition(const std::string& /*text*/) {
  return refused(conditions_);
}

std::optional<bool> NoVariables::holds(Condition& /*condition*/) { return std::nullopt; }

std::optional<double> NoVariables::value(const std::string& /*name*/, std::size_t /*level*/) {
  return std::nullopt;
}

base::Outcome<void> NoVariables::set(const std::string& /*name*/, double /*value*/) {
  return refused(variables_);
}

VariableListing NoVariables::list(std::span<const double> /*values*/, std::size_t /*level*/) {
  return {};
}

}  // namespace kerf::machine
