// How a live machine comes to its program.
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/dialect/registry.hpp"
#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

std::string LiveCore::language_of(const std::string& dialect) const {
  if (!dialect.empty()) return dialect;
  return settings_.dialect.empty() ? definition_.dialect : settings_.dialect;
}

LiveCore::Outcome LiveCore::can_load(const base::ProgramText& program,
                                     const std::string& dialect) const {
  if (is_active()) return refused(base::Refusal::load_busy);
  if (auto known = check_dialect(definition_, language_of(dialect)); !known) return known;
  const auto file = program.open();
  if (!file) return tl::unexpected(file.error());
  return {};
}

LiveCore::Outcome LiveCore::load(base::ProgramText program, std::string dialect) {
  if (auto possible = can_load(program, dialect); !possible) return possible;
  dialect_ = language_of(dialect);
  program_ = std::move(program);
  panel_alarm_.reset();
  begin_anew();
  return open_program();
}

base::Outcome<void> LiveCore::open_program() {
  if (!program_) return {};
  auto file = program_->open();
  if (!file) return tl::unexpected(file.error());
  machine_->load(std::move(*file));
  stepper_->attach(machine_->language());
  return {};
}

bool LiveCore::is_pattern() const { return dialect_ == kPatternDialect; }

bool LiveCore::would_begin_by_hand() const {
  return is_pattern() && moved_by_ == MovedBy::program && !is_active() &&
         !machine_->is_in_program();
}

// Nothing is accepted without effect.
void LiveCore::tell_pattern_times() {
  const bool changes =
      panel_[Switch::dry_run] || panel_.dials.feed != 100 || panel_.dials.rapid != 100;
  if (is_pattern() && changes)
    say("the pulses of a pattern have their own times: dry run and the dials do not change them; "
        "a dial at 0 holds");
}

LiveCore::Outcome LiveCore::begin_program() {
  if (is_pattern() && !PatternMachine::of(definition_)->is_at_zero(standing_joints()))
    return refused(base::Refusal::pattern_not_at_zero);
  begin_anew(MovedBy::program);
  if (auto opened = open_program(); !opened) return opened;
  stepper_->start();
  before_ = at_stop_ = values();
  messages_.clear();
  tell_pattern_times();
  ++run_;
  return {};
}

}  // namespace kerf::machine
