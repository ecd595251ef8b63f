#pragma once

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// Programmed moves: G00, G01, G02, G03, G33 and what they share: tool length, stroke limits, feed
/// (docs/dialect.md §8.1, §8.2).
class Moves {
 public:
  Moves(State& state, Targets& targets) : state_(state), targets_(targets) {}

  /// Executes the move of a block in the active motion mode. `moved` tells whether the block
  /// commands axis movement, be it of length zero. False: an alarm was raised, nothing has
  /// happened.
  [[nodiscard]] bool execute(const Words& words, bool& moved);

  /// A line to a target, fast or at feed by the active motion mode. False: an alarm was raised.
  [[nodiscard]] bool straight(const Words& words, const Target& target);

  /// Whether a cutting move has a feed; alarm PS0011 without one, PS1202 in G93 without F in the
  /// block.
  [[nodiscard]] bool has_feed(const Words& words);
  [[nodiscard]] motion::Feed feed() const { return {state_.words.feed, state_.modal.feed_mode()}; }

  /// The lead of a thread: F of the block, else the feed in force. Alarm PS0011 without one, PS1541
  /// without a speed.
  [[nodiscard]] bool read_lead(const Words& words, double& lead);

  /// Whether every axis can go as fast as a thread from here asks for; alarm SPINDLE_TOO_FAST, or
  /// PS0313 where its lead shrinks to nothing on the way.
  [[nodiscard]] bool can_follow_spindle(const motion::Thread& thread);

  /// The active length offset takes effect on its axis if that is among `named`.
  void apply_length(base::AxisSet named);
  /// Stored stroke limits and the largest coordinate. `target` without tool length.
  [[nodiscard]] bool check_limits(const base::AxisVector& target);
  /// To where a cycle or the block itself positions: fast, by the one-shot code of the block.
  [[nodiscard]] bool position(const base::ProgramPoint& program);
  /// Straight move, fast or at feed, to a programmed point; the programmed point is there
  /// afterwards.
  [[nodiscard]] bool rapid_to(const base::ProgramPoint& program);
  [[nodiscard]] bool line_to(const base::ProgramPoint& program, const motion::Feed& feed);

 private:
  void apply_tool_offset(base::AxisSet named);
  [[nodiscard]] Meaning motion_mode() const;
  bool unevenly_scaled_centre(const motion::PlaneAxes& plane, const Target& target,
                              geometry::Vec2 centre, bool clockwise, geometry::Vec2& image);
  bool check_axes(const Target& target);
  bool arc(const Words& words, bool clockwise, const Target& target);
  void cut_standing(const Words& words);
  bool thread(const Words& words, const Target& target);
  bool read_start(const Words& words, motion::Thread& cut);
  bool read_centre(const Words& words, const motion::PlaneAxes& plane, const Target& target,
                   bool clockwise, geometry::Vec2& centre, bool& nothing);
  void tell_run_in(const motion::Thread& thread, const base::TipPoint& from, double rpm);
  bool centre_offset(const Words& words, char letter, double& mm);
  bool finish(const Target& target, const base::PathPoint& path);

  State& state_;
  Targets& targets_;
};

}  // namespace kerf::control
