// The life of a machine under its panel: runs begin, go on, are held and end.
#include "machine/panel/internal/live_core.hpp"

#include <algorithm>

#include "lang/vm/value.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/dialect/registry.hpp"
#include "machine/panel/internal/approach.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

constexpr std::size_t kMostMessages = 50;

}  // namespace

LiveCore::LiveCore(RunStart start)
    : definition_(std::move(start.definition)),
      settings_(std::move(start.settings)),
      dialect_(std::move(start.dialect)),
      panel_(start.panel),
      program_(std::move(start.program)) {
  machine_ = std::make_unique<PacedRun>(
      definition_, std::move(start.memory),
      Machine::Settings{.dialect = dialect_, .signals = start.signals, .by_hand = true});
  machine_->language().set_shift(start.shift);
  printed_ = std::move(start.printed);
  printed_bytes_ = start.printed_bytes;
  stepper_ = std::make_unique<Stepper>(machine_->language());
  begin_anew();
  static_cast<void>(open_program());
  static_cast<void>(stepper_->set_breakpoints(std::move(start.breakpoints)));
}

LiveCore::~LiveCore() = default;

RunStart LiveCore::run_start() const {
  const motion::AxisPoint at = machine_->servo().stands_at();
  RunStart start{definition_,
                 machine_->memory(),
                 settings_,
                 dialect_,
                 panel_,
                 program_,
                 stepper_->breakpoints(),
                 machine_->language().shift(),
                 machine_->signals(),
                 printed_,
                 printed_bytes_};
  start.definition.start = at.joints;
  start.definition.axes.start = at.tip.tip;
  return start;
}

void LiveCore::add_sink(motion::MotionSink& sink) {
  sinks_.push_back(&sink);
  machine_->add_sink(sink);
}

void LiveCore::add_point_sink(motion::AxisPointSink& sink) {
  point_sinks_.push_back(&sink);
  machine_->add_point_sink(sink);
}

void LiveCore::tell_sinks() { machine_->servo().tell_sinks(); }

void LiveCore::raise(const base::Diagnostic& alarm) { machine_->raise(alarm); }

// A machine in the state of power-on, its axes where they stand.
void LiveCore::begin_anew(MovedBy moved_by) {
  RunStart start = run_start();
  moved_by_ = moved_by;
  const bool counts = is_pattern() && moved_by == MovedBy::program;
  definition_ = counts ? PatternMachine::at_zero(start.definition) : start.definition;
  auto fresh =
      std::make_unique<PacedRun>(definition_, std::move(start.memory),
                                 Machine::Settings{.dialect = dialect_,
                                                   .library_folders = settings_.library_folders,
                                                   .signals = start.signals,
                                                   .by_hand = moved_by == MovedBy::hand});
  fresh->language().set_shift(start.shift);
  auto trail = std::make_unique<BlockTrail>(fresh->language(), fresh->memory());
  auto read_ahead = std::make_unique<ReadAhead>(fresh->control(), *stepper_);
  fresh->add_sink(*trail);
  fresh->add_sink(*read_ahead);
  fresh->add_point_sink(*this);
  for (motion::MotionSink* const sink : sinks_) fresh->add_sink(*sink);
  for (motion::AxisPointSink* const sink : point_sinks_) fresh->add_point_sink(*sink);
  fresh->observe_rest([this] { trail_->settle(); });
  fresh->alter_motions([this](const motion::Motion& motion) { return altered(motion); });
  fresh->set_print_output([this](std::string_view text) {
    printed_bytes_ += text.size();
    printed_ += text;
    if (printed_.size() > settings_.printed_bytes)
      printed_.erase(0, printed_.size() - settings_.printed_bytes);
  });
  fresh->set_input_ready([this] { return !input_.empty(); });
  fresh->set_input([this]() -> std::optional<std::string> {
    if (input_.empty()) return std::nullopt;
    std::string line = std::move(input_.front());
    input_.pop_front();
    return line;
  });
  stepper_->attach(fresh->language());
  machine_ = std::move(fresh);
  trail_ = std::move(trail);
  read_ahead_ = std::move(read_ahead);
  latest_ = {};
  lines_ = {};
  approach_.reset();
  activity_ = Activity::none;
  is_entry_ = feed_hold_ = block_hold_ = dial_hold_ = resetting_ = was_stepping_ = false;
  deadline_s_ = 0;
  entered_.clear();
  said_ = 0;
  interrupts_missed_ = 0;
  apply_panel();
  tell_sinks();
}

// Dry run: cuts at the jog speed.
motion::Motion LiveCore::altered(const motion::Motion& motion) const {
  if (!panel_[Switch::dry_run] || activity_ != Activity::program || !motion::is_cut_at_feed(motion))
    return motion;
  motion::Motion dry = motion;
  const motion::Feed feed{settings_.jog_mm_min, motion::FeedMode::per_minute};
  std::visit(
      [&](auto& action) {
        if constexpr (requires { action.feed; }) action.feed = feed;
      },
      dry.action);
  return dry;
}

// A dial at 0 holds the motions that it is for; the others go on.
void LiveCore::take(const motion::AxisPoint& point) {
  latest_.take(machine_->servo().last());
  const motion::MoveKind kind = point.tip.mark.kind;
  const bool at_zero = (kind == motion::MoveKind::cut && panel_.dials.feed == 0) ||
                       (kind == motion::MoveKind::rapid && panel_.dials.rapid == 0);
  if (!at_zero || machine_->servo().source().wants_hold()) return;
  dial_hold_ = true;
  machine_->servo().source().hold();
}

// Time

void LiveCore::advance(double seconds) {
  if (!is_active()) return;
  deadline_s_ += seconds;
  advance_to(deadline_s_, kNever);
}

void LiveCore::advance_to(double until_s, const Moment& last) {
  reached_ = false;
  while (is_active()) {
    reached_ = machine_->advance(until_s, last);
    tell_missed_interrupts();
    planner::SetpointSource& source = machine_->servo().source();
    if (is_active() && block_hold_ && source.held() && source.empty() && machine_->has_halted()) {
      block_hold_ = false;
      source.resume();
      continue;
    }
    if (is_active()) break;
    after_activity();
  }
  // Time in which the axes wait for the control is not made up for.
  if (!reached_) deadline_s_ = time_s();
}

void LiveCore::after_activity() {
  if (resetting_ || (is_broken_off() && !machine_->servo().at_rest())) forget_ahead();
  if (resetting_) return finish_reset();
  switch (std::exchange(activity_, Activity::none)) {
    case Activity::none: break;
    case Activity::program: finish_program(); break;
    case Activity::jog:
      if (std::exchange(stopping_jog_, false)) {
        machine_->drop_ahead();
      } else if (jog_end_) {
        raise_panel(jog_end_->code, jog_end_->sentence);
      }
      jog_end_.reset();
      break;
    case Activity::home:
      if (!ended_early()) say("all axes are at their reference points");
      break;
    case Activity::approach:
      approach_.reset();
      if (!ended_early()) go_on();
      break;
  }
}

// The joints could not follow the moves to their end.
bool LiveCore::ended_early() {
  const auto end = std::exchange(jog_end_, {});
  if (end) raise_panel(end->code, end->sentence);
  return end.has_value();
}

void LiveCore::finish_program() {
  feed_hold_ = block_hold_ = false;
  if (stepper_->hit() || machine_->halt() != control::Halt::gate) stepper_->forget_target();
  const std::vector<std::string>& texts = machine_->statistics().messages();
  for (; said_ < texts.size(); ++said_) say(texts[said_]);
  before_ = std::exchange(at_stop_, values());
  ++changes_;
}

// Behind a drive that could not follow, the plan goes on without the axes: it is made anew.
void LiveCore::finish_reset() {
  if (is_broken_off()) {
    begin_anew();
    static_cast<void>(open_program());
    ++changes_;
    return;
  }
  machine_->drop_ahead();
  machine_->reset();
  machine_->abandon();
  activity_ = Activity::none;
  feed_hold_ = block_hold_ = dial_hold_ = resetting_ = stopping_jog_ = false;
  is_entry_ = false;
  jog_end_.reset();
  approach_.reset();
  stepper_->start();
  apply_panel();
  ++changes_;
}

void LiveCore::reset() {
  panel_alarm_.reset();
  messages_.clear();
  input_.clear();
  resetting_ = true;
  if (is_active()) {
    if (machine_->servo().at_rest()) trail_->settle();
    machine_->servo().source().reset();
  } else {
    finish_reset();
  }
}

void LiveCore::say(std::string message) {
  if (!messages_.empty() && messages_.back() == message) return;
  messages_.push_back(std::move(message));
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

void LiveCore::tell_missed_interrupts() {
  const std::uint64_t missed = machine_->control().interrupts_missed();
  if (std::exchange(interrupts_missed_, missed) < missed)
    say("an interrupt signal came while no M96 was in force: it did nothing");
}

void LiveCore::raise_panel(base::Code code, const std::string& sentence) {
  panel_alarm_ = base::make_error(code, {}, sentence);
}

// The program

bool LiveCore::would_begin() const {
  return panel_.mode == Mode::automatic && !is_active() && !panel_alarm_ && !machine_->alarm() &&
         (!machine_->is_in_program() || is_entry_);
}

std::optional<base::Failure> LiveCore::keeps_from_start() const {
  if (resetting_) return base::refuse(Refusal::resetting);
  if (panel_alarm_ || machine_->alarm()) return base::refuse(Refusal::alarm_is_on);
  if (panel_.mode == Mode::automatic) {
    if (!program_) return base::refuse(Refusal::no_program);
    return std::nullopt;
  }
  if (panel_.mode == Mode::mdi) {
    if (machine_->is_in_program() && is_entry_) return std::nullopt;
    return base::refuse(Refusal::no_entry);
  }
  return base::refuse(Refusal::start_in_mode, {std::string(name_of(panel_.mode))});
}

// Goes on from wherever the machine stands.
LiveCore::Outcome LiveCore::set_off(bool may_step) {
  was_stepping_ = may_step;
  planner::SetpointSource& source = machine_->servo().source();
  if (is_active()) {
    resume_feed();
    const bool whole_blocks = panel_[Switch::single_block] || may_step;
    if (activity_ == Activity::program && whole_blocks && !source.empty()) {
      source.hold_behind_block();
      block_hold_ = true;
    }
    return {};
  }
  if (approach_) return begin_approach();
  go_on();
  return {};
}

void LiveCore::go_on() {
  activity_ = Activity::program;
  deadline_s_ = time_s();
  trail_->settle();
  stepper_->go_on();
  if (!machine_->set_off()) {
    activity_ = Activity::none;
    finish_program();
  }
}

void LiveCore::resume_feed() {
  feed_hold_ = block_hold_ = false;
  if (!dial_hold_) machine_->servo().source().resume();
}

LiveCore::Outcome LiveCore::cycle_start() {
  if (const auto why = keeps_from_start()) return refused(*why);
  if (is_active() && !feed_hold_ && !block_hold_) return refused(Refusal::running);
  if (would_begin()) {
    if (auto begun = begin_program(); !begun) return begun;
  }
  return set_off(false);
}

LiveCore::Outcome LiveCore::feed_hold() {
  if (!is_active()) return refused(Refusal::nothing_to_hold);
  if (activity_ == Activity::jog) return jog_stop();
  feed_hold_ = true;
  block_hold_ = false;
  machine_->servo().source().hold();
  return {};
}

LiveCore::Outcome LiveCore::step(Step how) {
  if (const auto why = keeps_from_start()) return refused(*why);
  if (is_active() && !feed_hold_ && !block_hold_) return refused(Refusal::running_hold_first);
  if (would_begin()) {
    if (auto begun = begin_program(); !begun) return begun;
    how = Step::into;
  }
  stepper_->step(is_active() ? Step::into : how);
  return set_off(true);
}

LiveCore::Outcome LiveCore::run_to(const std::string& file, std::uint32_t line) {
  if (const auto why = keeps_from_start()) return refused(*why);
  if (line == 0) return refused("lines are counted from 1");
  if (is_active() && !feed_hold_ && !block_hold_) return refused(Refusal::running_hold_first);
  if (would_begin()) {
    if (auto begun = begin_program(); !begun) return begun;
  }
  stepper_->run_to(file, line);
  return set_off(false);
}

LiveCore::Outcome LiveCore::interrupt() {
  if (!machine_->is_in_program()) return refused(Refusal::nothing_to_interrupt);
  machine_->control().interrupt();
  return {};
}

LiveCore::Outcome LiveCore::set_breakpoints(std::vector<Breakpoint> breakpoints) {
  return stepper_->set_breakpoints(std::move(breakpoints));
}

LiveCore::Outcome LiveCore::mdi(const std::string& text) {
  if (panel_.mode != Mode::mdi) return refused(Refusal::entry_mode);
  if (is_pattern()) return refused(Refusal::pattern_entry);
  if (is_active()) return refused(Refusal::busy);
  if (panel_alarm_ || machine_->alarm()) return refused(Refusal::alarm_is_on);
  if (machine_->is_in_program() && !is_entry_) return refused(Refusal::interrupted);
  if (text.find_first_not_of(" \t\r\n;") == std::string::npos) return refused(Refusal::empty_entry);
  machine_->abandon();
  stepper_->start();
  before_ = at_stop_ = values();
  is_entry_ = true;
  activity_ = Activity::program;
  deadline_s_ = time_s();
  trail_->settle();
  ++run_;
  if (!machine_->set_off_entry(base::SourceFile::from_text("MDI", text))) {
    activity_ = Activity::none;
    finish_program();
  }
  return {};
}

LiveCore::Outcome LiveCore::enter(std::string line) {
  input_.push_back(std::move(line));
  return {};
}

// What was read, and the axes

bool LiveCore::is_ahead() const {
  return is_active() && activity_ == Activity::program && !machine_->servo().at_rest();
}

bool LiveCore::moves_as(const LiveCore& other) const {
  return is_active() == other.is_active() && latest_ == other.latest_;
}

bool LiveCore::stands() const {
  if (!is_active()) return true;
  const planner::SetpointSource& source = machine_->servo().source();
  return source.held() || source.standing() || machine_->servo().at_rest();
}

std::size_t LiveCore::shown_level() {
  const BlockState* const made = block_made();
  const std::size_t levels = made ? made->calls.size() : machine_->control().open_calls().size();
  return levels == 0 ? 0 : levels - 1;
}

void LiveCore::act_before(std::uint64_t block, const std::function<Outcome(LiveCore&)>& act) {
  stepper_->before_block(block, [this, act] { has_refused_ |= !act(*this); });
}

void LiveCore::replace(const LiveCore& other) {
  stepper_->forget_acts();
  stepper_->count_blocks(false);
  deadline_s_ = other.deadline_s_;
  changes_ = other.changes_ + 1;
}

base::JointPoint LiveCore::standing_joints() const { return machine_->servo().stands_at().joints; }

}  // namespace kerf::machine
