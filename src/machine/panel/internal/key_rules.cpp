#include "machine/panel/internal/key_rules.hpp"

namespace kerf::machine {
namespace {

template <typename... Keys>
bool is_one_of(const Operation& key) {
  return (std::holds_alternative<Keys>(key) || ...);
}

bool is_input(const std::string& name, LiveCore& core) {
  return core.machine().language().variables().is_input(name);
}

}  // namespace

bool begins_run(const Operation& key, const LiveCore& core) {
  if (is_one_of<Load, StartAt>(key)) return true;
  if (is_one_of<CycleStart, TakeStep, RunTo>(key)) return would_begin(core.standing());
  if (is_one_of<Jog, JogBy>(key)) return core.run().is_behind_pattern();
  if (is_one_of<Reset>(key)) return core.run().is_broken_off();
  const auto* const turned = std::get_if<TurnSwitch>(&key);
  return turned != nullptr && turned->which == Switch::machine_lock;
}

Operation in_full(Operation key, LiveCore& core) {
  if (auto* const jog = std::get_if<JogBy>(&key); jog && jog->speed_per_min == 0)
    jog->speed_per_min = core.own_speed(*jog);
  return key;
}

std::optional<Operation> acts_on_axes(const Operation& key, LiveCore& core) {
  LiveRun& run = core.run();
  if (!run.is_ahead()) return std::nullopt;
  if (is_one_of<Interrupt>(key)) return key;
  if (const auto* const skip = std::get_if<SetBlockSkip>(&key)) {
    const bool is_read = run.begun().slashes != run.read().slashes;
    return is_read && Switchboard::check(*skip) ? std::optional(key) : std::nullopt;
  }
  const auto* const variable = std::get_if<SetVariable>(&key);
  if (variable == nullptr || !run.stands() || is_input(variable->name, core)) return std::nullopt;
  return SetVariable{variable->name, variable->value, core.shown_level(*variable)};
}

}  // namespace kerf::machine
