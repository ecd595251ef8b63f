#pragma once

#include <array>
#include <deque>

#include "machine/dialect/pattern_motors.hpp"
#include "machine/dialect/pattern_queue.hpp"
#include "machine/run/pulse_lines.hpp"
#include "planner/setpoint_source.hpp"

namespace kerf::machine {

/// Set-points of the records of a pattern: one for every period of the servo, joints on the lines
/// that their pulses follow (docs/pattern.md, "On the panel"). Without an operator they are those
/// of PatternReplay.
///
/// Pulses have times of their own, which no override changes. A hold comes at the end of a cut,
/// which is half a second away at most with the usual timers; a fast record is cut short where its
/// ramp allows it, and the rest of it follows when the feed goes on. Where a record begins at other
/// counters than those at which the motors stand, behind a start in the middle, fast moves bring
/// them there first: lift clear of the work, T2, T1, T3, lift.
class PatternSource final : public planner::SetpointSource {
 public:
  /// Both must outlive the source. The axes stand where every counter is 0.
  PatternSource(const PatternMachine& machine, PatternQueue& records);

  [[nodiscard]] bool room() const override { return items_.size() < kRoom; }
  void take(const motion::Motion& motion) override;
  void finish() override { is_finished_ = true; }
  [[nodiscard]] bool next(motion::Setpoint& point) override;
  void skip() override;
  [[nodiscard]] double time_s() const override { return time_of(tick_); }
  [[nodiscard]] const base::TipPoint& tip() const override { return at_.tip; }
  [[nodiscard]] base::TipPoint motion_end() const override { return motors_.tip(); }
  /// Where the driven axes stand at the last point.
  [[nodiscard]] const base::JointPoint& joints() const { return at_.joints; }

  void set_overrides(const planner::Overrides& /*overrides*/) override {}
  void set_spindle_override(double /*factor*/) override {}
  void hold() override { hold_ = Hold::at_once; }
  void hold_behind_block() override;
  void resume() override;
  void reset() override;
  [[nodiscard]] bool wants_hold() const override { return hold_ != Hold::none; }
  [[nodiscard]] bool held() const override { return is_held_; }
  [[nodiscard]] bool at_reset() const override { return is_held_ && hold_ == Hold::reset; }
  [[nodiscard]] bool empty() const override { return items_.empty() && !is_under_way_; }
  [[nodiscard]] bool standing() const override { return is_resting_; }

 private:
  static constexpr std::size_t kRoom = 64;
  enum class Hold : std::uint8_t { none, behind_block, at_once, reset };
  struct Item {
    QueuedRecord queued;
    motion::Mark mark;
  };

  [[nodiscard]] double time_of(std::uint64_t tick) const;
  [[nodiscard]] std::array<double, drive::kArmAxes> counts_at(double time_s);
  [[nodiscard]] bool holds_here() const;
  void begin_record();
  void end_record();
  void make(const drive::PatternRecord& record);
  void approach(const Item& next);
  void cut_short();
  void drop();
  bool rest(motion::Setpoint& point);
  bool stand(motion::Setpoint& point);
  void tell(motion::Setpoint& point, const std::array<double, drive::kArmAxes>& counts);

  const PatternMachine& machine_;
  PatternQueue& records_;
  double period_s_;
  PulseLines lines_;      // of the record under way
  PatternMotors motors_;  // at the end of the record under way
  PatternMotors before_;  // at its begin
  std::deque<Item> items_;
  std::uint64_t motions_ = 0;  // taken

  Item under_way_;  // or the one before, while there is none
  bool is_under_way_ = false;
  double end_s_ = 0;          // of it
  double motors_late_s_ = 0;  // time at a point, less that of the motors: they count no rests
  bool is_resting_ = true;    // the last point is behind the end of the record
  bool is_finished_ = true;

  Hold hold_ = Hold::none;
  bool is_held_ = false;
  bool is_block_over_ = false;  // since the hold behind a block was asked for
  bool is_cut_short_ = false;   // the record under way, for a hold

  std::uint64_t tick_ = 0;
  PatternStand at_;
};

}  // namespace kerf::machine
