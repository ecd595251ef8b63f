#include "machine/dialect/internal/pattern_dialect.hpp"

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

}  // namespace kerf::machine
