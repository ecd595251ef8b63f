#include "machine/dialect/internal/basic_dialect.hpp"

namespace kerf::machine {

BasicDialect::BasicDialect(const Around& around)
    : Dialect(around.sources),
      program_(around.sources, around.pages),
      control_(around.definition.parameters, around.definition.axes, around.memory, program_,
               around.surroundings, around.sink),
      variables_(program_, control_) {}

std::optional<base::Diagnostic> BasicDialect::start() {
  if (!program_.loaded()) return base::make_error(base::Code::empty_program, {});
  if (!program_.findings().empty()) return program_.findings().front();
  control_.start();
  variables_.begin();
  return std::nullopt;
}

void BasicDialect::reset() {
  control_.reset();
  variables_.end();
}

void BasicDialect::check(base::Findings& found) {
  if (program_.loaded()) program_.check(program_name(), found);
}

}  // namespace kerf::machine
