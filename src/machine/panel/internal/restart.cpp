// Start at a line: the control runs up to it while nothing moves, then the axes are brought to
// where it has them.
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/approach.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

// More than any program of a person needs to come to a line; an endless loop ends here.
constexpr std::uint64_t kSteps = 50'000'000;
constexpr std::uint64_t kSlice = 100'000;

}  // namespace

LiveCore::Outcome LiveCore::start_at(std::uint32_t line) {
  if (panel_.mode != Mode::automatic) return refused(Refusal::start_mode);
  if (const auto why = keeps_from_start()) return refused(*why);
  if (is_active()) return refused(Refusal::running);
  if (auto begun = begin_program(); !begun) return begun;
  control::Memory before = machine_->memory();
  auto approach = std::make_unique<Approach>();
  approach->to = machine_->servo().commanded();
  machine_->divert_motions(approach.get());
  machine_->control().set_single_block(false);
  stepper_->search_line(line);
  bool found = false;
  const auto alarmed = [line](const base::Diagnostic& alarm) {
    return base::refuse_for(alarm.number, Refusal::start_alarm,
                            {std::to_string(line), alarm.message});
  };
  base::Failure why = base::refuse(Refusal::start_not_reached, {std::to_string(line)});
  if (!machine_->set_off()) why = alarmed(*machine_->alarm());
  const auto goes_on = [&](std::uint64_t steps) {
    return steps < kSteps && machine_->is_active() && !limit_.reached();
  };
  for (std::uint64_t steps = 0; goes_on(steps); steps += kSlice) {
    if (!machine_->execute(kSlice)) continue;
    const control::Halt halt = machine_->halt();
    found = halt == control::Halt::gate;
    if (halt == control::Halt::end)
      why = base::refuse(Refusal::start_ends_before, {std::to_string(line)});
    if (halt == control::Halt::alarm) why = alarmed(*machine_->control().alarm());
    if (found || halt == control::Halt::end || halt == control::Halt::alarm) break;
  }
  stepper_->search_line(0);
  machine_->divert_motions(nullptr);
  if (!found) {
    set_memory(std::move(before));
    begin_anew();
    if (auto opened = open_program(); !opened) return opened;
    return refused(why);
  }
  machine_->stand_by();
  apply_panel();
  approach_ = std::move(approach);
  before_ = at_stop_ = values();
  return {};
}

// The tool's axis goes last, or first where it goes away from the work.
LiveCore::Outcome LiveCore::begin_approach() {
  std::vector<motion::Motion> motions;
  if (is_pattern()) approach_->to = machine_->servo().commanded();  // its motors go there by pulses
  for (const auto* const function : {&approach_->tool, &approach_->spindle, &approach_->coolant}) {
    if (*function) motions.push_back(**function);
  }
  const base::TipPoint from = machine_->servo().commanded();
  base::TipPoint corner = approach_->to;
  if (const auto z = definition_.axes.find('Z'); z && approach_->to[*z] < from[*z]) {
    corner[*z] = from[*z];
  } else if (z) {
    corner = from;
    corner[*z] = approach_->to[*z];
  }
  motion::Motion move;
  move.block.line = machine_->control().standing_at().line;
  move.block.file = machine_->control().standing_at().file;
  for (const base::TipPoint& to : {corner, approach_->to}) {
    if (to == (motions.empty() || motion::target_of(motions.back()) == nullptr
                   ? from
                   : *motion::target_of(motions.back())))
      continue;
    move.action = motion::Rapid{to, true};
    motions.push_back(move);
  }
  if (motions.empty()) {
    approach_.reset();
    go_on();
    return {};
  }
  jog_end_.reset();
  activity_ = Activity::approach;
  return queue_moves(motions);
}

}  // namespace kerf::machine
