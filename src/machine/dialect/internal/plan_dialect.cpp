#include "machine/dialect/internal/plan_dialect.hpp"

namespace kerf::machine {

PlanDialect::PlanDialect(const Around& around)
    : Dialect(around.sources),
      maker_(around.plan),
      control_(around.definition.axes, around.definition.parameters.stroke_check != 0, *maker_,
               around.surroundings, around.sink) {}

std::optional<base::Diagnostic> PlanDialect::start() {
  control_.start();
  return std::nullopt;
}

}  // namespace kerf::machine
