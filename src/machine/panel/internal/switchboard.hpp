#pragma once

#include "base/result.hpp"
#include "machine/panel/internal/live_run.hpp"
#include "machine/panel/operation.hpp"

namespace kerf::machine {

/// The mode switch, the switches and the dials, as they stand, and what they do to a run.
class Switchboard {
 public:
  using Outcome = base::Outcome<void>;

  explicit Switchboard(const PanelSettings& panel) : panel_(panel) {}

  [[nodiscard]] const PanelSettings& panel() const { return panel_; }
  [[nodiscard]] Mode mode() const { return panel_.mode; }
  [[nodiscard]] bool operator[](Switch which) const { return panel_[which]; }

  /// All of it to a run that begins.
  void apply(LiveRun& run) const;
  /// Of the switches those that the control and the servo know.
  void apply_switches(LiveRun& run) const;
  /// Dry run: cuts go at this speed.
  [[nodiscard]] motion::Motion altered(const motion::Motion& motion, const LiveRun& run,
                                       double dry_mm_min) const;

  [[nodiscard]] Outcome turn(const SetMode& key, const LiveRun& run);
  /// Notes where it stands.
  [[nodiscard]] Outcome turn(const TurnSwitch& key, const LiveRun& run);
  /// Single block was turned: what is under way is held behind its block, or not any more.
  static void obey_single_block(bool on, LiveRun& run);
  [[nodiscard]] Outcome turn(const SetDials& key, LiveRun& run);
  /// Of a pattern, which dry run and dials do not change: nothing is accepted without effect.
  void tell_pattern_times(const LiveRun& run, Console& console) const;
  [[nodiscard]] static Outcome check(const SetBlockSkip& key);
  void show(const SetBlockSkip& key) { panel_.skip_levels = key.levels; }

 private:
  PanelSettings panel_;
};

}  // namespace kerf::machine
