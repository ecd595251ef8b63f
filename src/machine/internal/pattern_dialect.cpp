#include "machine/internal/pattern_dialect.hpp"

namespace kerf::machine {

PatternDialect::PatternDialect(const Around& around)
    : Dialect(around.sources),
      machine_(*PatternMachine::of(around.definition)),
      library_(around.sources, around.pages),
      control_(machine_, library_, around.records, around.sink) {}

std::optional<base::Diagnostic> PatternDialect::start() {
  if (!library_.loaded()) return base::make_error(base::Code::empty_program, {});
  control_.start(program_name());
  return std::nullopt;
}

void PatternDialect::check(base::Findings& found) {
  if (library_.loaded()) library_.check(program_name(), found);
}

std::optional<base::Diagnostic> PatternDialect::start_entry(base::FileId file) {
  load_file(file);
  return start();
}

base::Outcome<Condition> PatternDialect::compile_condition(const std::string& /*text*/) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage,
                                      "a pattern has no variables, and so no conditions"});
}

std::optional<bool> PatternDialect::holds(Condition& /*condition*/) { return std::nullopt; }

std::optional<double> PatternDialect::variable(const std::string& /*name*/, std::size_t /*level*/) {
  return std::nullopt;
}

base::Outcome<void> PatternDialect::set_variable_at(const std::string& name, double value,
                                                    std::size_t /*level*/) {
  return set_variable(name, value);
}

VariableListing PatternDialect::list_variables(std::span<const double> /*values*/,
                                               std::size_t /*level*/) {
  return {};
}

base::Outcome<void> PatternDialect::set_variable(const std::string& /*name*/, double /*value*/) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, "a pattern has no variables"});
}

}  // namespace kerf::machine
