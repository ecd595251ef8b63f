// How a live machine comes to its program.
#include <algorithm>

#include "machine/internal/live_core.hpp"
#include "machine/internal/refused.hpp"

namespace kerf::machine {

std::string LiveCore::language_of(const std::string& dialect) const {
  if (!dialect.empty()) return dialect;
  return settings_.dialect.empty() ? definition_.dialect : settings_.dialect;
}

LiveCore::Outcome LiveCore::can_load(const ProgramText& program, const std::string& dialect) const {
  if (is_active()) return refused(base::Refusal::load_busy);
  const std::string language = language_of(dialect);
  const auto known = available_dialects();
  if (std::find(known.begin(), known.end(), language) == known.end())
    return refused("Kerf does not run the language '" + language + "'");
  const auto file = program.open();
  if (!file) return tl::unexpected(file.error());
  return {};
}

LiveCore::Outcome LiveCore::load(ProgramText program, std::string dialect) {
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

LiveCore::Outcome LiveCore::begin_program() {
  begin_anew();
  if (auto opened = open_program(); !opened) return opened;
  stepper_->start();
  before_ = at_stop_ = values();
  messages_.clear();
  ++run_;
  return {};
}

}  // namespace kerf::machine
