// The switches and dials of the panel.
#include <algorithm>

#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {
namespace {

using base::Refusal;

// What a dial at 0 is until the first point of a motion that it holds.
constexpr double kCreep = 1e-4;

}  // namespace

void LiveCore::apply_panel() {
  apply_switches();
  machine_->control().set_block_skip(panel_.skip_levels);
  apply_dials();
}

void LiveCore::apply_switches() {
  control::Control& control = machine_->control();
  control.set_single_block(panel_[Switch::single_block]);
  control.set_optional_stop(panel_[Switch::optional_stop]);
  machine_->servo().lock(panel_[Switch::machine_lock]);
}

void LiveCore::apply_dials() {
  const auto share = [](int percent) { return std::max(percent / 100.0, kCreep); };
  planner::SetpointSource& source = machine_->servo().source();
  source.set_overrides({share(panel_.dials.feed), share(panel_.dials.rapid)});
  source.set_spindle_override(panel_.dials.spindle / 100.0);
  machine_->servo().set_power_override(panel_.dials.spindle / 100.0);
}

LiveCore::Outcome LiveCore::set_mode(Mode mode) {
  if (mode == panel_.mode) return {};
  if (is_active() || resetting_)
    return refused(feed_hold_ ? Refusal::mode_held : Refusal::mode_running);
  panel_.mode = mode;
  return {};
}

LiveCore::Outcome LiveCore::set_switch(Switch which, bool on) {
  if (panel_[which] == on) return {};
  if (which == Switch::dry_run && is_active()) return refused(Refusal::dry_run_moving);
  if (which == Switch::machine_lock && (is_active() || machine_->is_in_program()))
    return refused(Refusal::lock_in_program);
  panel_.switches[static_cast<std::size_t>(which)] = on;
  if (which == Switch::dry_run && machine_->is_in_program()) tell_pattern_times();
  if (which == Switch::machine_lock) {
    begin_anew();
    if (!on) say("machine lock is off: the position is that of the axes again");
    return open_program();
  }
  apply_switches();
  if (which == Switch::single_block && is_active() && activity_ == Activity::program) {
    planner::SetpointSource& source = machine_->servo().source();
    if (on && !feed_hold_) {
      source.hold_behind_block();
      block_hold_ = true;
    } else if (!on && block_hold_ && !source.held()) {
      resume_feed();
    }
  }
  return {};
}

LiveCore::Outcome LiveCore::check_skip_levels(std::uint32_t levels) {
  constexpr std::uint32_t kLevels = 0x3fe;
  if ((levels & ~kLevels) != 0) return refused("blocks are skipped by levels 1 to 9");
  return {};
}

LiveCore::Outcome LiveCore::show_block_skip(std::uint32_t levels) {
  panel_.skip_levels = levels;
  return {};
}

LiveCore::Outcome LiveCore::apply_block_skip(std::uint32_t levels) {
  machine_->control().set_block_skip(levels);
  return {};
}

LiveCore::Outcome LiveCore::set_block_skip(std::uint32_t levels) {
  if (auto checked = check_skip_levels(levels); !checked) return checked;
  static_cast<void>(show_block_skip(levels));
  return apply_block_skip(levels);
}

LiveCore::Outcome LiveCore::set_dials(const OverrideDials& dials) {
  const auto within = [](int value, int low, int high) { return low <= value && value <= high; };
  if (!within(dials.feed, 0, 200)) return refused("the feed override is 0 to 200 percent");
  if (!within(dials.rapid, 0, 100)) return refused("the rapid override is 0 to 100 percent");
  if (!within(dials.spindle, 50, 120)) return refused("the spindle override is 50 to 120 percent");
  panel_.dials = dials;
  apply_dials();
  if (machine_->is_in_program()) tell_pattern_times();
  if (!dial_hold_) return {};
  const motion::MoveKind kind = machine_->servo().last().mark.kind;
  const int dial = kind == motion::MoveKind::rapid ? dials.rapid : dials.feed;
  if (dial == 0) return {};
  dial_hold_ = false;
  if (!feed_hold_ && !resetting_ && !block_hold_) machine_->servo().source().resume();
  return {};
}

}  // namespace kerf::machine
