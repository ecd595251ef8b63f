#include "machine/panel/internal/live_core.hpp"

#include <cassert>
#include <utility>

#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {

using base::Refusal;

LiveCore::LiveCore(RunStart start)
    : definition_(std::move(start.definition)),
      settings_(std::move(start.settings)),
      slot_(settings_.dialect.empty() ? definition_.dialect : settings_.dialect,
            std::move(start.dialect), std::move(start.program)),
      switchboard_(start.panel),
      console_(settings_.printed_bytes, std::move(start.printed), start.printed_bytes) {
  PacedRun first(
      definition_, std::move(start.memory),
      Machine::Settings{.dialect = slot_.dialect(), .signals = start.signals, .by_hand = true});
  first.language().set_shift(start.shift);
  stepper_ = std::make_unique<Stepper>(first.language());
  begin_with(start_of(first), MovedBy::hand);
  static_cast<void>(open_program());
  static_cast<void>(stepper_->set_breakpoints(std::move(start.breakpoints)));
}

RunStart LiveCore::start_of(const PacedRun& machine) const {
  const motion::AxisPoint at = machine.servo().stands_at();
  RunStart start{definition_,
                 machine.memory(),
                 settings_,
                 slot_.dialect(),
                 switchboard_.panel(),
                 slot_.text(),
                 stepper_->breakpoints(),
                 machine.language().shift(),
                 machine.signals(),
                 console_.printed(),
                 console_.printed_bytes()};
  start.definition.start = at.joints;
  start.definition.axes.start = at.tip.tip;
  return start;
}

void LiveCore::add_sink(motion::MotionSink& sink) {
  sinks_.push_back(&sink);
  machine().add_sink(sink);
}

void LiveCore::add_point_sink(motion::AxisPointSink& sink) {
  point_sinks_.push_back(&sink);
  machine().add_point_sink(sink);
}

// A machine in the state of power-on, its axes where they stand.
void LiveCore::begin_with(RunStart start, MovedBy moved_by) {
  const bool counts = slot_.is_pattern() && moved_by == MovedBy::program;
  definition_ = counts ? PatternMachine::at_zero(start.definition) : start.definition;
  auto fresh =
      std::make_unique<LiveRun>(definition_, std::move(start.memory),
                                Machine::Settings{.dialect = slot_.dialect(),
                                                  .library_folders = settings_.library_folders,
                                                  .signals = start.signals,
                                                  .by_hand = moved_by == MovedBy::hand},
                                *stepper_, moved_by, run_ ? run_->number() : 0);
  fresh->machine().language().set_shift(start.shift);
  join(*fresh);
  stepper_->attach(fresh->machine().language());
  run_ = std::move(fresh);
  entries_ = {};
  approach_.reset();
  switchboard_.apply(*run_);
  tell_sinks();
}

void LiveCore::join(LiveRun& run) {
  PacedRun& machine = run.machine();
  for (motion::MotionSink* const sink : sinks_) machine.add_sink(*sink);
  for (motion::AxisPointSink* const sink : point_sinks_) machine.add_point_sink(*sink);
  machine.alter_motions([this, &run](const motion::Motion& motion) {
    return switchboard_.altered(motion, run, settings_.jog_mm_min);
  });
  machine.set_print_output([this](std::string_view text) { console_.print(text); });
  machine.set_input_ready([this] { return console_.has_line(); });
  machine.set_input([this] { return console_.next_line(); });
}

// Time

void LiveCore::advance(double seconds) {
  if (!is_active()) return;
  run_->deadline_s += seconds;
  advance_to(run_->deadline_s, kNever);
}

void LiveCore::advance_to(double until_s, const Moment& last) {
  reached_ = false;
  while (is_active()) {
    reached_ = machine().advance(until_s, last);
    run_->tell_missed_interrupts(console_);
    if (run_->outruns_block_hold()) continue;
    if (is_active()) break;
    after_activity();
  }
  // Time in which the axes wait for the control is not made up for.
  if (!reached_) run_->deadline_s = time_s();
}

void LiveCore::after_activity() {
  if (run_->is_resetting || (run_->is_broken_off() && !machine().servo().at_rest()))
    run_->forget_ahead();
  if (run_->is_resetting) return finish_reset();
  switch (run_->end_activity()) {
    case Activity::none: break;
    case Activity::program: finish_program(); break;
    case Activity::jog: hand().finish_jog(); break;
    case Activity::home:
      if (!run_->ended_early(console_)) console_.say("all axes are at their reference points");
      break;
    case Activity::approach:
      approach_.reset();
      if (!run_->ended_early(console_)) go_on();
      break;
  }
}

void LiveCore::finish_program() {
  run_->release_holds();
  if (stepper_->hit() || machine().halt() != control::Halt::gate) stepper_->forget_target();
  run_->tell_messages(console_);
  view_.note_stop(*run_);
  view_.note_change();
}

// Behind a drive that could not follow, the plan goes on without the axes: it is made anew.
void LiveCore::finish_reset() {
  view_.note_change();
  if (run_->is_broken_off()) {
    begin_anew();
    static_cast<void>(open_program());
    return;
  }
  run_->finish_reset();
  approach_.reset();
  stepper_->start();
  switchboard_.apply(*run_);
}

// Keys

LiveCore::Outcome LiveCore::perform(const Operation& key) {
  return std::visit([this](const auto& each) { return act(each); }, key);
}

LiveCore::Outcome LiveCore::act(const Load& key) {
  if (auto possible = can_load(key); !possible) return possible;
  slot_.put(key);
  console_.forget_alarm();
  begin_anew();
  return open_program();
}

LiveCore::Outcome LiveCore::act(const CycleStart& /*key*/) {
  if (const auto why = keeps_from_start(standing())) return refused(*why);
  if (is_active() && !run_->is_held()) return refused(Refusal::running);
  if (would_begin(standing())) {
    if (auto begun = begin_program(); !begun) return begun;
  }
  return set_off(false);
}

LiveCore::Outcome LiveCore::act(const FeedHold& /*key*/) {
  if (!is_active()) return refused(Refusal::nothing_to_hold);
  if (run_->is(Activity::jog)) return act(JogStop{});
  run_->hold_feed();
  return {};
}

LiveCore::Outcome LiveCore::act(const Reset& /*key*/) {
  console_.reset();
  run_->is_resetting = true;
  if (!is_active()) {
    finish_reset();
    return {};
  }
  if (machine().servo().at_rest()) run_->trail().settle();
  run_->source().reset();
  return {};
}

LiveCore::Outcome LiveCore::act(const TurnSwitch& key) {
  if (switchboard_[key.which] == key.on) return {};
  if (auto turned = switchboard_.turn(key, *run_); !turned) return turned;
  if (key.which == Switch::dry_run && machine().is_in_program())
    switchboard_.tell_pattern_times(*run_, console_);
  if (key.which == Switch::machine_lock) {
    begin_anew();
    if (!key.on) console_.say("machine lock is off: the position is that of the axes again");
    return open_program();
  }
  switchboard_.apply_switches(*run_);
  if (key.which == Switch::single_block) Switchboard::obey_single_block(key.on, *run_);
  return {};
}

LiveCore::Outcome LiveCore::act(const SetDials& key) {
  if (auto turned = switchboard_.turn(key, *run_); !turned) return turned;
  if (machine().is_in_program()) switchboard_.tell_pattern_times(*run_, console_);
  return {};
}

template <typename Key>
LiveCore::Outcome LiveCore::move_by_hand(const Key& key) {
  if (const auto why = hand().objection(key)) return refused(*why);
  // The motors that count a pattern are left to the interpolator.
  if (run_->is_behind_pattern()) {
    begin_anew();
    static_cast<void>(open_program());
  }
  return hand().go(key);
}

LiveCore::Outcome LiveCore::act(const Home& key) {
  if (const auto why = hand().objection(key)) return refused(*why);
  return hand().go(key);
}

LiveCore::Outcome LiveCore::act(const EnterBlocks& key) {
  if (const auto why = keeps_from_entry(standing())) return refused(*why);
  if (key.text.find_first_not_of(" \t\r\n;") == std::string::npos)
    return refused(Refusal::empty_entry);
  machine().abandon();
  stepper_->start();
  view_.note_start(*run_);
  run_->is_entry = true;
  run_->begin_next(Activity::program);
  run_->trail().settle();
  end_unless(machine().set_off_entry(base::SourceFile::from_text("MDI", key.text)));
  return {};
}

LiveCore::Outcome LiveCore::act(const TakeStep& key) {
  if (const auto why = keeps_from_step(standing())) return refused(*why);
  Step how = key.how;
  if (would_begin(standing())) {
    if (auto begun = begin_program(); !begun) return begun;
    how = Step::into;
  }
  stepper_->step(is_active() ? Step::into : how);
  return set_off(true);
}

LiveCore::Outcome LiveCore::act(const StepBack& /*key*/) {
  assert(false);  // it is the run that goes back, not the machine
  return {};
}

LiveCore::Outcome LiveCore::act(const RunTo& key) {
  if (const auto why = keeps_from_start(standing())) return refused(*why);
  if (key.line == 0) return refused("lines are counted from 1");
  if (const auto why = keeps_from_step(standing())) return refused(*why);
  if (would_begin(standing())) {
    if (auto begun = begin_program(); !begun) return begun;
  }
  stepper_->run_to(key.file, key.line);
  return set_off(false);
}

LiveCore::Outcome LiveCore::act(const StartAt& key) {
  if (const auto why = keeps_from_start_at(standing())) return refused(*why);
  if (auto begun = begin_program(); !begun) return begun;
  control::Memory before = machine().memory();
  auto approach = std::make_unique<Approach>();
  if (auto found = approach->search(*run_, *stepper_, key.line, limit_); !found) {
    set_memory(std::move(before));
    begin_anew();
    if (auto opened = open_program(); !opened) return opened;
    return found;
  }
  switchboard_.apply(*run_);
  approach_ = std::move(approach);
  view_.note_start(*run_);
  return {};
}

void LiveCore::set_memory(control::Memory memory) {
  run_->set_memory(std::move(memory));
  stepper_->forget_values();
  view_.note_change();
}

// Keys that act where the axes are

LiveCore::Outcome LiveCore::act(const SetBlockSkip& key) {
  if (auto checked = Switchboard::check(key); !checked) return checked;
  switchboard_.show(key);
  return take_effect(key);
}

LiveCore::Outcome LiveCore::act(const Interrupt& /*key*/) {
  if (!machine().is_in_program()) return refused(Refusal::nothing_to_interrupt);
  machine().control().interrupt();
  return {};
}

LiveCore::Outcome LiveCore::act(const SetVariable& key) {
  if (machine().language().variables().is_input(key.name))
    return act(SetInput{key.name, key.value.value_or(0)});
  if (!run_->stands()) return refused(Refusal::variables_moving);
  const SetVariable shown{key.name, key.value, shown_level(key)};
  if (auto set = take_effect_of(key); !set) return set;
  entries_.show(shown, *run_);
  return {};
}

std::size_t LiveCore::shown_level(const SetVariable& key) {
  return key.level.value_or(innermost(run_->shown_levels()));
}

LiveCore::Outcome LiveCore::take_effect_of(const SetVariable& key) {
  if (auto set = entries_.enter(key, *run_); !set) return set;
  stepper_->forget_values();
  view_.note_change();
  return {};
}

void LiveCore::show(const Operation& key) {
  if (const auto* const skip = std::get_if<SetBlockSkip>(&key)) switchboard_.show(*skip);
  if (const auto* const variable = std::get_if<SetVariable>(&key)) entries_.show(*variable, *run_);
}

LiveCore::Outcome LiveCore::take_effect(const Operation& key) {
  if (const auto* const variable = std::get_if<SetVariable>(&key)) return take_effect_of(*variable);
  const auto* const skip = std::get_if<SetBlockSkip>(&key);
  if (skip == nullptr) return perform(key);
  machine().control().set_block_skip(skip->levels);
  return {};
}

void LiveCore::act_before(std::uint64_t block, const Operation& key) {
  stepper_->before_block(block, [this, key] { has_refused_ |= !take_effect(key); });
}

// The program

LiveCore::Outcome LiveCore::can_load(const Load& key) const {
  if (is_active()) return refused(Refusal::load_busy);
  return slot_.check(key, definition_);
}

LiveCore::Outcome LiveCore::begin_program() {
  if (slot_.is_pattern() && !PatternMachine::of(definition_)->is_at_zero(run_->standing_joints()))
    return refused(Refusal::pattern_not_at_zero);
  begin_anew(MovedBy::program);
  if (auto opened = open_program(); !opened) return opened;
  stepper_->start();
  view_.note_start(*run_);
  console_.forget_messages();
  switchboard_.tell_pattern_times(*run_, console_);
  run_->set_number(run_->number() + 1);
  return {};
}

// Goes on from wherever the machine stands.
LiveCore::Outcome LiveCore::set_off(bool may_step) {
  run_->was_stepping = may_step;
  if (is_active()) {
    run_->resume_feed();
    const bool whole_blocks = panel()[Switch::single_block] || may_step;
    if (run_->is(Activity::program) && whole_blocks && !run_->source().empty())
      run_->hold_behind_block();
    return {};
  }
  if (approach_) return begin_approach();
  go_on();
  return {};
}

void LiveCore::go_on() {
  run_->begin(Activity::program);
  run_->trail().settle();
  stepper_->go_on();
  end_unless(machine().set_off());
}

// What has not begun is over, in an alarm.
void LiveCore::end_unless(bool begun) {
  if (begun) return;
  static_cast<void>(run_->end_activity());
  finish_program();
}

LiveCore::Outcome LiveCore::begin_approach() {
  const std::vector<motion::Motion> motions = approach_->motions(*run_, definition_.axes);
  if (motions.empty()) {
    approach_.reset();
    go_on();
    return {};
  }
  run_->hand_end.reset();
  run_->begin(Activity::approach);
  return run_->move_by_hand(motions);
}

// To see

Snapshot LiveCore::snapshot() {
  return view_.snapshot({*run_, panel(), console_, *stepper_, slot_.text().has_value()});
}

bool LiveCore::moves_as(const LiveCore& other) const {
  return is_active() == other.is_active() && run_->latest() == other.run_->latest();
}

void LiveCore::stand_for_itself() {
  stepper_->forget_acts();
  stepper_->count_blocks(false);
  run_->deadline_s = time_s();
}

void LiveCore::replace(const LiveCore& other) {
  stand_for_itself();
  run_->deadline_s = other.run_->deadline_s;
  view_.note_change(other.view_);
}

}  // namespace kerf::machine
