#include "machine/internal/teach_dialect.hpp"

#include "machine/taught_for.hpp"

namespace kerf::machine {

TeachDialect::TeachDialect(const Around& around)
    : library_(around.sources, around.pages),
      control_(around.definition.axes, taught_for(around.definition), library_, around.surroundings,
               around.sink) {}

std::optional<base::Diagnostic> TeachDialect::start() {
  if (!library_.loaded()) return base::make_error(base::Code::empty_program, {});
  control_.start(program_name());
  return std::nullopt;
}

std::vector<base::Diagnostic> TeachDialect::check() {
  if (!library_.loaded()) return {};
  std::vector<base::Diagnostic> found = library_.check();
  for (base::Diagnostic& diagnostic : found) diagnostic.program = program_name();
  return found;
}

base::Outcome<void> TeachDialect::set_variable(const std::string& /*name*/, double /*value*/) {
  return tl::unexpected(
      base::Failure{base::Failure::Kind::usage, "taught points have no variables"});
}

}  // namespace kerf::machine
