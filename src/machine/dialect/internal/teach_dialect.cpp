#include "machine/dialect/internal/teach_dialect.hpp"

#include "machine/dialect/taught_for.hpp"

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

}  // namespace kerf::machine
