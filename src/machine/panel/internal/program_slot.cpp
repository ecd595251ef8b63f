#include "machine/panel/internal/program_slot.hpp"

#include "machine/dialect/refused.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::machine {

bool ProgramSlot::is_pattern() const { return dialect_ == kPatternDialect; }

std::string ProgramSlot::language_of(const Load& key) const {
  return key.dialect.empty() ? own_dialect_ : key.dialect;
}

ProgramSlot::Outcome ProgramSlot::check(const Load& key, const MachineDefinition& machine) const {
  if (auto known = check_dialect(machine, language_of(key)); !known) return known;
  const auto file = key.program.open();
  if (!file) return tl::unexpected(file.error());
  return {};
}

void ProgramSlot::put(const Load& key) {
  dialect_ = language_of(key);
  text_ = key.program;
}

ProgramSlot::Outcome ProgramSlot::open(PacedRun& machine, Stepper& stepper) const {
  if (!text_) return {};
  auto file = text_->open();
  if (!file) return tl::unexpected(file.error());
  machine.load(std::move(*file));
  stepper.attach(machine.language());
  return {};
}

}  // namespace kerf::machine
