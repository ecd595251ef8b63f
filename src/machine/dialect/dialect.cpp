#include "machine/dialect/dialect.hpp"

#include <cassert>

#include "machine/dialect/internal/basic_dialect.hpp"
#include "machine/dialect/internal/gcode_dialect.hpp"
#include "machine/dialect/internal/motion_dialect.hpp"
#include "machine/dialect/internal/pattern_dialect.hpp"
#include "machine/dialect/internal/plan_dialect.hpp"
#include "machine/dialect/internal/teach_dialect.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::machine {

bool Dialect::is_file(const std::string& name, base::FileId file) const {
  if (!sources_.contains(file)) return false;
  const std::string& whole = sources_[file].name();
  return whole == name || (whole.size() > name.size() && whole.ends_with(name) &&
                           whole[whole.size() - name.size() - 1] == '/');
}

base::Outcome<void> check_dialect(const MachineDefinition& machine, std::string_view dialect) {
  if (find_dialect(dialect) == nullptr) {
    return tl::unexpected(
        base::Failure{base::Failure::Kind::usage,
                      "Kerf does not run the language '" + std::string(dialect) + "'"});
  }
  if (dialect != kPatternDialect) return {};
  const auto counting = PatternMachine::of(machine);
  if (!counting) return tl::unexpected(counting.error());
  return {};
}

std::unique_ptr<Dialect> make_dialect(std::string_view name, const Dialect::Around& around) {
  if (around.plan) return std::make_unique<PlanDialect>(around);
  const DialectRow* const row = find_dialect(name);
  assert(row != nullptr);
  switch (row->kind) {
    case DialectRow::Kind::gcode:
      return std::make_unique<GcodeDialect>(around, row->codes(around.definition.parameters));
    case DialectRow::Kind::basic: return std::make_unique<BasicDialect>(around);
    case DialectRow::Kind::teach: return std::make_unique<TeachDialect>(around);
    case DialectRow::Kind::motion: return std::make_unique<MotionDialect>(around);
    case DialectRow::Kind::pattern: return std::make_unique<PatternDialect>(around);
  }
  return nullptr;
}

}  // namespace kerf::machine
