#include "machine/panel/internal/switchboard.hpp"

#include "machine/dialect/refused.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {
namespace {

using base::Refusal;

base::Outcome<void> check_dial(const char* name, std::optional<int> percent, const Range& range) {
  if (!percent || range.has(*percent)) return {};
  return refused(std::string("the ") + name + " override is " +
                 std::to_string(static_cast<int>(range.least)) + " to " +
                 std::to_string(static_cast<int>(range.most)) + " percent");
}

std::optional<base::Failure> objection(const TurnSwitch& key, const LiveRun& run) {
  if (key.which == Switch::dry_run && run.is_active()) return base::refuse(Refusal::dry_run_moving);
  if (key.which == Switch::machine_lock && (run.is_active() || run.machine().is_in_program()))
    return base::refuse(Refusal::lock_in_program);
  return std::nullopt;
}

}  // namespace

void Switchboard::apply(LiveRun& run) const {
  apply_switches(run);
  run.machine().control().set_block_skip(panel_.skip_levels);
  run.set_dials(panel_.dials);
}

void Switchboard::apply_switches(LiveRun& run) const {
  control::Control& control = run.machine().control();
  control.set_single_block(panel_[Switch::single_block]);
  control.set_optional_stop(panel_[Switch::optional_stop]);
  run.machine().servo().lock(panel_[Switch::machine_lock]);
}

motion::Motion Switchboard::altered(const motion::Motion& motion, const LiveRun& run,
                                    double dry_mm_min) const {
  if (!panel_[Switch::dry_run] || !run.is(Activity::program) || !motion::is_cut_at_feed(motion))
    return motion;
  motion::Motion dry = motion;
  const motion::Feed feed{dry_mm_min, motion::FeedMode::per_minute};
  std::visit(
      [&](auto& action) {
        if constexpr (requires { action.feed; }) action.feed = feed;
      },
      dry.action);
  return dry;
}

Switchboard::Outcome Switchboard::turn(const SetMode& key, const LiveRun& run) {
  if (key.mode == panel_.mode) return {};
  if (run.is_active() || run.is_resetting)
    return refused(run.is_feed_held() ? Refusal::mode_held : Refusal::mode_running);
  panel_.mode = key.mode;
  return {};
}

Switchboard::Outcome Switchboard::turn(const TurnSwitch& key, const LiveRun& run) {
  if (const auto why = objection(key, run)) return refused(*why);
  panel_.switches[static_cast<std::size_t>(key.which)] = key.on;
  return {};
}

void Switchboard::obey_single_block(bool on, LiveRun& run) {
  if (!run.is_active() || !run.is(Activity::program)) return;
  if (on && !run.is_feed_held()) {
    run.hold_behind_block();
  } else if (!on && run.is_held_behind_block() && !run.source().held()) {
    run.resume_feed();
  }
}

Switchboard::Outcome Switchboard::turn(const SetDials& key, LiveRun& run) {
  if (auto fits = check_dial("feed", key.feed, SetDials::kFeed); !fits) return fits;
  if (auto fits = check_dial("rapid", key.rapid, SetDials::kRapid); !fits) return fits;
  if (auto fits = check_dial("spindle", key.spindle, SetDials::kSpindle); !fits) return fits;
  OverrideDials& dials = panel_.dials;
  dials = {key.feed.value_or(dials.feed), key.rapid.value_or(dials.rapid),
           key.spindle.value_or(dials.spindle)};
  run.set_dials(dials);
  return {};
}

void Switchboard::tell_pattern_times(const LiveRun& run, Console& console) const {
  const bool changes =
      panel_[Switch::dry_run] || panel_.dials.feed != 100 || panel_.dials.rapid != 100;
  if (run.is_pattern() && changes)
    console.say(
        "the pulses of a pattern have their own times: dry run and the dials do not change them; "
        "a dial at 0 holds");
}

Switchboard::Outcome Switchboard::check(const SetBlockSkip& key) {
  constexpr std::uint32_t kLevels = 0x3fe;
  if ((key.levels & ~kLevels) != 0) return refused("blocks are skipped by levels 1 to 9");
  return {};
}

}  // namespace kerf::machine
