#include "machine/internal/teach_dialect.hpp"

#include "machine/internal/refused.hpp"
#include "machine/taught_for.hpp"

namespace kerf::machine {

TeachDialect::TeachDialect(const Around& around)
    : Dialect(around.sources),
      library_(around.sources, around.pages),
      control_(around.definition.axes, taught_for(around.definition), library_, around.surroundings,
               around.sink) {}

std::optional<base::Diagnostic> TeachDialect::start() {
  if (!library_.loaded()) return base::make_error(base::Code::empty_program, {});
  control_.start(program_name());
  return std::nullopt;
}

void TeachDialect::check(base::Findings& found) {
  if (library_.loaded()) library_.check(program_name(), found);
}

std::optional<base::Diagnostic> TeachDialect::start_entry(base::FileId file) {
  load_file(file);
  return start();
}

base::Outcome<Condition> TeachDialect::compile_condition(const std::string& /*text*/) {
  return refused(base::Refusal::taught_conditions);
}

std::optional<bool> TeachDialect::holds(Condition& /*condition*/) { return std::nullopt; }

std::optional<double> TeachDialect::variable(const std::string& /*name*/, std::size_t /*level*/) {
  return std::nullopt;
}

base::Outcome<void> TeachDialect::set_variable_at(const std::string& name, double value,
                                                  std::size_t /*level*/) {
  return set_variable(name, value);
}

void TeachDialect::read_variables(std::vector<double>& values) { values.clear(); }

VariableListing TeachDialect::list_variables(std::span<const double> /*values*/,
                                             std::size_t /*level*/) {
  return {};
}

base::Outcome<void> TeachDialect::set_variable(const std::string& /*name*/, double /*value*/) {
  return refused(base::Refusal::taught_variables);
}

}  // namespace kerf::machine
