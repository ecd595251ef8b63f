#include "machine/panel/internal/approach.hpp"

#include <algorithm>

#include "machine/dialect/refused.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

// More than any program of a person needs to come to a line; an endless loop ends here.
constexpr std::uint64_t kStepsAtMost = 50'000'000;
constexpr std::uint64_t kSliceOfApproach = 100'000;

// Executes until the control halts before the line. Why it does not; nothing: it does.
std::optional<base::Failure> run_up_to(std::uint32_t line, PacedRun& machine,
                                       const base::WorkLimit& limit) {
  const auto alarmed = [line](const base::Diagnostic& alarm) {
    return base::refuse_for(alarm.number, Refusal::start_alarm,
                            {std::to_string(line), alarm.message});
  };
  base::Failure why = base::refuse(Refusal::start_not_reached, {std::to_string(line)});
  if (!machine.set_off()) why = alarmed(*machine.alarm());
  const auto goes_on = [&](std::uint64_t steps) {
    return steps < kStepsAtMost && machine.is_active() && !limit.reached();
  };
  for (std::uint64_t steps = 0; goes_on(steps); steps += kSliceOfApproach) {
    if (!machine.execute(kSliceOfApproach)) continue;
    const control::Halt halt = machine.halt();
    if (halt == control::Halt::gate) return std::nullopt;
    if (halt == control::Halt::end)
      return base::refuse(Refusal::start_ends_before, {std::to_string(line)});
    if (halt == control::Halt::alarm) return alarmed(*machine.control().alarm());
  }
  return why;
}

base::TipPoint corner_between(const base::TipPoint& from, const base::TipPoint& to,
                              const motion::AxisSetup& axes) {
  const auto z = axes.find('Z');
  if (!z) return to;
  base::TipPoint corner = to[*z] < from[*z] ? to : from;
  corner[*z] = std::max(from[*z], to[*z]);
  return corner;
}

}  // namespace

void Approach::take(const motion::Motion& motion) {
  const auto keep = [&](std::optional<motion::Motion>& kept) { kept = motion; };
  if (std::holds_alternative<motion::ToolChange>(motion.action)) keep(tool_);
  if (std::holds_alternative<motion::Spindle>(motion.action)) keep(spindle_);
  if (std::holds_alternative<motion::Coolant>(motion.action)) keep(coolant_);
  if (const base::TipPoint* const target = motion::target_of(motion)) to_ = *target;
}

base::Outcome<void> Approach::search(LiveRun& run, Stepper& stepper, std::uint32_t line,
                                     const base::WorkLimit& limit) {
  PacedRun& machine = run.machine();
  to_ = machine.servo().commanded();
  machine.divert_motions(this);
  machine.control().set_single_block(false);
  stepper.search_line(line);
  const auto why = run_up_to(line, machine, limit);
  stepper.search_line(0);
  machine.divert_motions(nullptr);
  if (why) return refused(*why);
  machine.stand_by();
  return {};
}

std::vector<motion::Motion> Approach::motions(LiveRun& run, const motion::AxisSetup& axes) const {
  std::vector<motion::Motion> motions;
  for (const auto* const function : {&tool_, &spindle_, &coolant_}) {
    if (*function) motions.push_back(**function);
  }
  const base::TipPoint from = run.machine().servo().commanded();
  const base::TipPoint goal = run.is_pattern() ? from : to_;  // its motors go there by pulses
  motion::Motion move;
  move.block.line = run.machine().control().standing_at().line;
  move.block.file = run.machine().control().standing_at().file;
  for (const base::TipPoint& to : {corner_between(from, goal, axes), goal}) {
    const base::TipPoint* const last =
        motions.empty() ? nullptr : motion::target_of(motions.back());
    if (to == (last == nullptr ? from : *last)) continue;
    move.action = motion::Rapid{to, true};
    motions.push_back(move);
  }
  return motions;
}

}  // namespace kerf::machine
