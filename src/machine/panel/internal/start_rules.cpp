#include "machine/panel/internal/start_rules.hpp"

namespace kerf::machine {

using base::Failure;
using base::Refusal;

bool would_begin(const Standing& at) {
  return at.mode == Mode::automatic && !at.run.is_active() && !at.has_alarm &&
         (!at.run.machine().is_in_program() || at.run.is_entry);
}

std::optional<Failure> keeps_from_start(const Standing& at) {
  if (at.run.is_resetting) return base::refuse(Refusal::resetting);
  if (at.has_alarm) return base::refuse(Refusal::alarm_is_on);
  if (at.mode == Mode::automatic) {
    if (!at.has_program) return base::refuse(Refusal::no_program);
    return std::nullopt;
  }
  if (at.mode == Mode::mdi) {
    if (at.run.machine().is_in_program() && at.run.is_entry) return std::nullopt;
    return base::refuse(Refusal::no_entry);
  }
  return base::refuse(Refusal::start_in_mode, {std::string(name_of(at.mode))});
}

std::optional<Failure> keeps_from_step(const Standing& at) {
  if (auto why = keeps_from_start(at)) return why;
  if (at.run.is_active() && !at.run.is_held()) return base::refuse(Refusal::running_hold_first);
  return std::nullopt;
}

std::optional<Failure> keeps_from_start_at(const Standing& at) {
  if (at.mode != Mode::automatic) return base::refuse(Refusal::start_mode);
  if (auto why = keeps_from_start(at)) return why;
  if (at.run.is_active()) return base::refuse(Refusal::running);
  return std::nullopt;
}

std::optional<Failure> keeps_from_entry(const Standing& at) {
  if (at.mode != Mode::mdi) return base::refuse(Refusal::entry_mode);
  if (at.run.is_pattern()) return base::refuse(Refusal::pattern_entry);
  if (at.run.is_active()) return base::refuse(Refusal::busy);
  if (at.has_alarm) return base::refuse(Refusal::alarm_is_on);
  if (at.run.machine().is_in_program() && !at.run.is_entry)
    return base::refuse(Refusal::interrupted);
  return std::nullopt;
}

}  // namespace kerf::machine
